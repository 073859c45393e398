// SPDX-License-Identifier: GPL-3.0-or-later
// A job type of Flamenco 3. Each task flattens some of the models in a folder that all workers share.
// Copy this file to the folder `scripts` beside flamenco-manager. In flamenco-manager.yaml, define the variable
// {python} for each platform: the path of a Python in which wirewarp[command] is installed.

const JOB_TYPE = {
    label: "WireWarp Patterns",
    description: "Flatten every model in a folder, and write reports and patterns",
    settings: [
        { key: "models", type: "string", subtype: "dir_path", required: true,
          description: "Folder with the models" },
        { key: "patterns", type: "string", subtype: "dir_path", required: true,
          description: "Folder for reports and patterns" },
        { key: "options", type: "string", required: false, default: "--seams uv",
          description: "Options of python -m wirewarp batch, separated by spaces. For .blend files, add --blender" },
        { key: "parts", type: "int32", required: true, default: 20, propargs: { min: 1, max: 1000 },
          description: "Number of tasks that share the models" },
    ],
};

function compileJob(job) {
    const settings = job.settings;
    const options = (settings.options || "").split(" ").filter((word) => word !== "");
    for (let part = 1; part <= settings.parts; part++) {
        const task = author.Task(`models ${part} of ${settings.parts}`, "misc");
        task.addCommand(author.Command("exec", {
            exe: "{python}",
            args: ["-m", "wirewarp", "batch", settings.models, "--out", settings.patterns,
                   "--part", `${part}/${settings.parts}`].concat(options),
        }));
        job.addTask(task);
    }
}
