# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the pages on settings, errors and fabrics from the add-on itself, so that they always agree with it.

blender --background --addons wirewarp_addon --python docs/write_blender_pages.py -- FOLDER
"""

import importlib
import math
import re
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from error_examples import EXAMPLES, example_sentence  # noqa: E402 (the folder must be on the path first)

# This package is the extension or the legacy add-on.
ADDON = type(bpy.context.scene.wirewarp).__module__.rpartition(".")[0]
PARTS = {"FRONT": "Flatten", "MAIN": "Flatten > Settings", "ADVANCED": "Flatten > Settings > Advanced"}
PANELS = {  # the places at which Blender shows the other settings, by the name of their class
    "PatternSettings": "Export Pattern",
    "TargetSettings": "Suggest Darts and Suggest Seams",
    "EaseAmount": "Mark > Ease",
    "WIREWARP_PG_settings": "Auto, Tolerance, Overlay and previews",
}


def module(name: str) -> Any:  # noqa: ANN401
    return importlib.import_module(f"{ADDON}.{name}")


def table(head: Iterable[str], rows: Iterable[Iterable[str]]) -> list[str]:
    head = list(head)
    lines = [head, ["---"] * len(head), *rows]
    return ["| " + " | ".join(cell.replace("|", "\\|").replace("\n", " ") for cell in line) + " |" for line in lines]


def sentence(text: str) -> str:
    return text if not text or text.endswith(".") else text + "."


def value_text(prop: bpy.types.Property) -> str:
    """Return the default of a setting, with the range of a number."""
    match prop.type:
        case "BOOLEAN":
            return "on" if prop.default else "off"
        case "ENUM" if prop.is_enum_flag:
            return ", ".join(each.name for each in prop.enum_items if each.identifier in prop.default_flag)
        case "ENUM":
            default = prop.enum_items.get(prop.default)
            return default.name if default else ""
        case "INT":
            return f"{prop.default} ({prop.hard_min} to {prop.hard_max})"
        case "FLOAT":
            scale, unit = (180 / math.pi, "°") if prop.subtype == "ANGLE" else (1, "%" * (prop.subtype == "PERCENTAGE"))
            default, low, high = (f"{scale * v:.4g}{unit}" for v in (prop.default, prop.hard_min, prop.hard_max))
            return f"{default} ({low} to {high})" if prop.hard_max < 1e30 else default
    return ""


def about(prop: bpy.types.Property) -> str:
    """Return the description of a setting, with its choices."""
    choices = [f"<br>*{each.name}*: {sentence(each.description)}" for each in getattr(prop, "enum_items", ())]
    described = [text for text in choices if not text.endswith("*: ")]
    return sentence(prop.description) + "".join(described)


def settings_of_scene() -> Iterator[tuple[str, list[bpy.types.Property]]]:
    """Yield each group of the scene's settings, with the panel that shows it."""
    settings = bpy.context.scene.wirewarp
    properties = settings.bl_rna.properties
    table = module("state.settings").SETTINGS
    for part, panel in PARTS.items():
        yield panel, [properties[each.name] for each in table if each.part(settings) == part]
    kinds = [kind for kind in type(settings).__mro__ if vars(kind).get("__annotations__")]
    for kind in [*kinds[1:], kinds[0]]:  # base classes first, then the class of the settings itself
        if kind.__name__ != "FlattenSettings":
            yield PANELS[kind.__name__], [properties[name] for name in vars(kind)["__annotations__"]]


def button_texts() -> dict[str, list[str]]:
    """Return, for each operator, the texts of its buttons that differ from its label."""
    texts: dict[str, list[str]] = {}
    for file in sorted(Path(sys.modules[ADDON].__file__).parent.rglob("*.py")):
        for name, text in re.findall(r'operator\(\s*"([\w.]+)", text="([^"]+)"', file.read_text(encoding="utf-8")):
            if text not in texts.setdefault(name, []):
                texts[name].append(text)
    return texts


def operators() -> list[type[bpy.types.Operator]]:
    found = {
        each
        for each in bpy.types.Operator.__subclasses__()
        if each.__module__.split(".")[: ADDON.count(".") + 1] == ADDON.split(".")
    }
    shown = [each for each in found if "INTERNAL" not in getattr(each, "bl_options", ())]
    return sorted(shown, key=lambda each: each.bl_label)


def settings_page() -> list[str]:
    lines = [
        "# Settings and buttons",
        "",
        "This page is written from the add-on. Numbers are defaults, with the allowed range in brackets.",
    ]
    for panel, settings in settings_of_scene():
        rows = ([f"**{each.name}**", value_text(each), about(each), f"`{each.identifier}`"] for each in settings)
        lines += ["", f"## {panel}", "", *table(["Setting", "Default", "What it does", "In scripts"], rows)]
    export = bpy.ops.object.wirewarp_export.get_rna_type().properties
    shared = {each.identifier for _, settings in settings_of_scene() for each in settings}
    own = [each for each in export if not each.is_hidden and each.name and each.identifier not in {*shared, "rna_type"}]
    rows = ([f"**{each.name}**", value_text(each), about(each), f"`{each.identifier}`"] for each in own)
    lines += [
        "",
        "## Export Pattern, in the file dialog",
        "",
        *table(["Setting", "Default", "What it does", "In scripts"], rows),
    ]
    texts = button_texts()
    rows = (
        [
            ", ".join(f"**{text}**" for text in dict.fromkeys([each.bl_label, *texts.get(each.bl_idname, [])])),
            sentence(description(each)),
            f"`bpy.ops.{each.bl_idname}`",
        ]
        for each in operators()
    )
    return [*lines, "", "## Buttons", "", *table(["Button", "What it does", "In scripts"], rows), ""]


def description(operator: type[bpy.types.Operator]) -> str:
    return " ".join((getattr(operator, "bl_description", "") or operator.__doc__ or "").split())


def errors_page() -> list[str]:
    library = module("core").library()
    sentences = module("solve.error_sentences")
    rows = [[example_sentence(library, sentences, each), f"`{each[0]}`"] for each in EXAMPLES]
    codes = [
        [f"`{code.value}`", sentence(code.meaning), sentence(code.remedy), sentence(code.arguments)]
        for code in library.ErrorCode
    ]
    return [
        "# Error messages",
        "",
        "This page is written from the add-on and the library. Search it for the sentence that you see. Counts,",
        "lengths and the wires Hip and Bust are examples.",
        "",
        "## In Blender",
        "",
        "The report shows the name of the piece before the sentence. The arrow beside the sentence selects the place.",
        "",
        *table(["Message", "Code"], rows),
        "",
        "## In Python and on the command line",
        "",
        "`FlattenError.code` is one of these codes, and `FlattenError.arguments` has the values in the last column.",
        "",
        *table(["Code", "Meaning", "What to do", "Arguments"], codes),
        "",
    ]


def fabrics_page() -> list[str]:
    cloth = module("core").library().Cloth
    rows = []
    for name in cloth.presets():
        across, along = (f"{100 * share:.3g}%" for share in cloth.preset(name).limits)
        texts = cloth.about(name)
        rows.append(
            [
                f"**{texts['label']}**",
                across,
                along,
                sentence(texts["description"]),
                sentence(texts["source"]),
                f"`{name}`",
            ]
        )
    return [
        "# Fabrics",
        "",
        "The table has the presets, with the maximum stretch that the verdict assumes.",
        "Fabric differs from bolt to bolt. If the two figures of the verdict are close,",
        "[measure your fabric](../how-to/fabric.md#measure-the-stretch-of-your-fabric).",
        "",
        *table(["Fabric", "Across", "Along the grain", "Examples", "Source of the figures", "In scripts"], rows),
        "",
    ]


folder = Path(sys.argv[sys.argv.index("--") + 1])
folder.mkdir(parents=True, exist_ok=True)
for name, page in (("settings.md", settings_page), ("errors.md", errors_page), ("fabrics.md", fabrics_page)):
    (folder / name).write_text("\n".join(page()), encoding="utf-8")
