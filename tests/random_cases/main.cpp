// SPDX-License-Identifier: GPL-3.0-or-later
// Usage: wirewarp_random_cases [--list] FIRST COUNT. Flattens COUNT random cases, with the seeds FIRST, FIRST + 1, ...,
// and judges the results. Exits with 1 if a guarantee is broken, or if an error is missing or unexpected. A case that
// takes too much processor time ends the program. At the end, prints how often each verdict occurred, and how many good
// pieces came from each start of the refined method (PieceReport::start). --list: prints a line for each piece instead
// of judging, to compare two builds piece by piece.
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "random_case.h"

namespace wirewarp::test {
namespace {

// Limit of the processor time of all threads for one case. Other programs do not count. The slowest of 10,000 cases
// takes 13 s, and 30 times as long with the sanitizers.
constexpr long kSecondsPerCase = 1000;
std::array<char, 64> current_case{};  // text for the signal handler, which may not allocate

/// Limits the processor time of the program. 0 removes the limit.
void limit_time(long seconds) {
  const itimerval limit{{0, 0}, {seconds, 0}};
  setitimer(ITIMER_PROF, &limit, nullptr);
}

void give_up(int) {
  const ssize_t written = write(STDERR_FILENO, current_case.data(), current_case.size());
  _exit(written > 0 ? 2 : 3);
}

void print(const Counts& counts) {
  for (const auto& [name, times] : counts) std::printf("%6d %s\n", times, name.c_str());
}

int run_all(std::uint64_t first, std::uint64_t count) {
  Counts outcomes, starts;
  int failures = 0;
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // so that no line is lost if the time limit ends the program
  std::signal(SIGPROF, give_up);
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    std::snprintf(current_case.data(), current_case.size(), "seed %llu takes too long\n",
                  static_cast<unsigned long long>(seed));
    limit_time(kSecondsPerCase);
    const RandomCase random_case = make_random_case(seed);
    const Outcome outcome = judge(random_case);
    ++outcomes[outcome.name];
    for (const auto& [name, times] : outcome.starts) starts[name] += times;
    if (outcome.broken.empty()) continue;
    ++failures;
    std::printf("seed %llu:%s\n", static_cast<unsigned long long>(seed), (" " + random_case.description).c_str());
    for (const std::string& sentence : outcome.broken) std::printf("    %s\n", sentence.c_str());
  }
  limit_time(0);
  print(outcomes);
  std::puts("good pieces by start:");
  print(starts);
  std::printf("%llu passed, %d failed\n", static_cast<unsigned long long>(count) - static_cast<unsigned>(failures),
              failures);
  return failures > 0 ? 1 : 0;
}

/// Prints a line for each piece: seed, number of the piece, verdict, start, objective and factorizations.
int list_all(std::uint64_t first, std::uint64_t count) {
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const RandomCase random_case = make_random_case(seed);
    const auto number = static_cast<unsigned long long>(seed);
    try {
      const FlattenResult result = flatten_with(random_case.input, random_case.options);
      for (std::size_t i = 0; i < result.pieces.size(); ++i) {
        const Piece& piece = result.pieces[i];
        const PieceReport& report = piece.report;
        std::printf("%llu %zu %s %s %.12g %d\n", number, i, piece.error ? describe(piece.error->code).name : "flat",
                    report.start.empty() ? "-" : report.start.c_str(), report.objective, report.factorizations);
      }
    } catch (const FlattenError& error) {
      std::printf("%llu - %s - - -\n", number, describe(error.code).name);
    }
  }
  return 0;
}

}  // namespace
}  // namespace wirewarp::test

int main(int argc, char** argv) {
  const bool is_list = argc > 1 && std::string(argv[1]) == "--list";
  if (argc != (is_list ? 4 : 3)) {
    std::fprintf(stderr, "usage: wirewarp_random_cases [--list] FIRST_SEED COUNT\n");
    return 2;
  }
  const auto number = [&](int index) { return std::strtoull(argv[index], nullptr, 10); };
  return is_list ? wirewarp::test::list_all(number(2), number(3)) : wirewarp::test::run_all(number(1), number(2));
}
