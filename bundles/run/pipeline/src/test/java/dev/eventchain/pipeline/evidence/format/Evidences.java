package dev.eventchain.pipeline.evidence.format;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.evidence.Evidence;
import dev.eventchain.pipeline.evidence.Evidence.About;
import dev.eventchain.pipeline.evidence.Evidence.Component;
import dev.eventchain.pipeline.evidence.Evidence.Requirement;
import dev.eventchain.pipeline.evidence.Evidence.Result;
import dev.eventchain.pipeline.evidence.Evidence.Strength;
import dev.eventchain.pipeline.evidence.Evidence.Test;
import dev.eventchain.pipeline.evidence.Evidence.Verdict;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Stream;

/** Evidence that tests write. */
final class Evidences {

  private Evidences() {}

  /** Returns evidence with one of everything. */
  static Evidence full() {
    return new Evidence(
        "brake",
        "Brake & <warn>",
        "FAILED: 1 of 3 scenarios passed",
        List.of(
            requirement("BRK-1", "It brakes.", Verdict.PROVED, "", strength(14, 14)),
            requirement("BRK-2", "It brakes with 9 m/s².", Verdict.PROVED, "", strength(3, 14)),
            requirement("BRK-3", "It stops.", Verdict.VIOLATED, "", Optional.empty()),
            requirement(
                "BRK-4",
                "It warns.",
                Verdict.NOT_TESTED,
                "scenario fog: *it* <warns>: nothing was near",
                strength(0, 4)),
            requirement(
                "BRK_5",
                "*It* has |a| `name_` <b>and</b> [x]_, \"q\" & \\.",
                Verdict.NOT_TESTED,
                "No scenario tests the requirement BRK_5",
                Optional.empty())),
        List.of(
            component("Brake", "BRK-1", "BRK-2", "BRK-3"), component("Warning", "BRK-4", "BRK_5")),
        List.of(
            test("Brake", "near enough", 2, Result.PASSED, "", "BRK-1"),
            test("Brake", "far @ 3 m", 6, Result.FAILED, "'force' is 0, not 1.", "BRK-3"),
            test("Warning", "lamp", 2, Result.NOT_TESTED, "It did not run.", "BRK-4"),
            scenario(
                "stopped",
                Result.PASSED,
                "3 criteria hold",
                about("BRK-2", Result.PASSED),
                about("BRK-1", Result.PASSED),
                about("BRK-3", Result.PASSED)),
            scenario(
                "late",
                Result.FAILED,
                "not met: the vehicle stops",
                about("BRK-1", Result.PASSED),
                about("BRK-3", Result.FAILED)),
            scenario(
                "fog",
                Result.NOT_TESTED,
                "not tested: <nothing> was near",
                about("BRK-4", Result.NOT_TESTED),
                about("BRK-2", Result.PASSED))));
  }

  /** Returns evidence of a project without requirements, components, tests and scenarios. */
  static Evidence none() {
    return new Evidence("none", "None", "INCOMPLETE: stopped", List.of(), List.of(), List.of());
  }

  private static Optional<Strength> strength(int noticed, int faults) {
    return Optional.of(new Strength(noticed, faults, OptionalLong.empty()));
  }

  private static Requirement requirement(
      String id, String text, Verdict verdict, String reason, Optional<Strength> strength) {
    Optional<String> why = Optional.of(reason).filter(it -> !it.isEmpty());
    return new Requirement(id, text, at("requirements.md", 2), verdict, why, strength);
  }

  private static Component component(String name, String... satisfies) {
    SourceLocation file = SourceLocation.of("software-base/components/" + name + ".py");
    return new Component(name, file, List.of(satisfies));
  }

  private static Test test(
      String component, String name, int line, Result result, String text, String requirement) {
    return new Test(
        name,
        Optional.of(component),
        at("tests/" + component + ".yaml", line),
        result,
        text,
        0,
        List.of(about(requirement, result)));
  }

  private static Test scenario(String name, Result result, String text, About... about) {
    return new Test(
        name,
        Optional.empty(),
        at("scenarios/" + name + ".yaml", 1),
        result,
        text,
        12.5,
        Stream.of(about).toList());
  }

  private static About about(String requirement, Result result) {
    return new About(requirement, result);
  }

  private static SourceLocation at(String file, int line) {
    return new SourceLocation(file, line, 3, "", "");
  }
}
