package dev.eventchain.diagnostics.format;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Coverage.Check;
import dev.eventchain.diagnostics.Coverage.Kind;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Report;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.diagnostics.Trial;
import java.time.LocalDate;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reports that tests render. */
public final class Reports {

  private static final SourceLocation NODE =
      new SourceLocation(
          "model/chain 1.xmi", 3, 4, "EventChain[a]/software[TTC]", "  <software name=\"TTC\"/>");

  private Reports() {}

  /** Returns a report with every kind of content. */
  public static Report full() {
    Diagnostic violated =
        Diagnostic.of(Rule.error("ocl.violated"), "Node 'TTC' [see](http://x) has no output.", NODE)
            .withHint("Give it an output.")
            .withRule("SoftwareNode::HasOutput")
            .withRelated(new SourceLocation("rules.ocl", 2, 5, "", "inv HasOutput: ..."));
    Diagnostic again = violated.withLocation(NODE.withElement("EventChain[a]/software[Brake]"));
    Diagnostic slow =
        Diagnostic.of(Rule.warning("ocl.violated"), "Node \u202E'TTC'\u0007 is slow.", NODE)
            .withRule("SoftwareNode::Fast");
    Diagnostic topic =
        Diagnostic.of(
            Rule.error("contract.topic.type"),
            "Two types on /scan.",
            SourceLocation.of("/abs/ü.json"));
    Diagnostic known = violated.withRule("SoftwareNode::Known");
    Diagnostic info = Diagnostic.of(Rule.info("file.odd"), "Odd.", SourceLocation.of("rules.ocl"));
    Diagnostic nowhere =
        Diagnostic.of(Rule.error("python.unavailable"), "No Python.", SourceLocation.NONE);
    Diagnostic missed =
        Diagnostic.of(
            Rule.error("simulation.criterion.failed"),
            "Scenario stop: expected it stops, but found: 3 m/s at the end.",
            new SourceLocation("scenarios/stop.yaml", 9, 5, "/accept/stops", "  stops: true"));
    Suppressions.Entry entry =
        new Suppressions.Entry(
            "ocl.violated",
            "*::Known",
            "",
            "",
            "",
            "Replaced in June <3.",
            LocalDate.of(2027, 6, 1),
            new SourceLocation("eventchain-suppressions.yaml", 1, 3, "", "- id: ocl.violated"));
    return new Report(
        "1.2.3",
        1,
        coverage(),
        List.of(violated, again, slow, topic, info, nowhere, missed),
        List.of(new Suppressions.Suppressed(known, entry)),
        trials(missed));
  }

  private static List<Trial> trials(Diagnostic missed) {
    return List.of(
        trial(Trial.Kind.SCENARIO, "stop", Trial.Outcome.FAILED, "not met: it stops", 12.5),
        trial(Trial.Kind.SCENARIO, "go", Trial.Outcome.PASSED, "2 criteria hold", 3),
        new Trial(
            Trial.Kind.CRITERION,
            "stop: it stops",
            Trial.Outcome.FAILED,
            "3 m/s at the end",
            12.5,
            List.of(missed)),
        trial(Trial.Kind.CRITERION, "go: no brake", Trial.Outcome.PASSED, "", 3),
        trial(Trial.Kind.CRITERION, "go: it is <seen>", Trial.Outcome.SKIPPED, "not tested", 3),
        trial(Trial.Kind.REQUIREMENT, "REQ-1", Trial.Outcome.FAILED, "violated", 15.5),
        linked("wait", Trial.Outcome.UNTESTED, List.of(), List.of("REQ-2")),
        linked("turn", Trial.Outcome.PASSED, List.of("REQ-3", "REQ \"4\""), List.of("REQ-5")),
        linked("free", Trial.Outcome.PASSED, List.of(), List.of()),
        trial(Trial.Kind.FAULT, "radar-dies in stop", Trial.Outcome.PASSED, "it stops", 12.5)
            .withFigures(Map.of("points", "1.5")));
  }

  private static Trial trial(
      Trial.Kind kind, String name, Trial.Outcome outcome, String text, double seconds) {
    return new Trial(kind, name, outcome, text, seconds, List.of());
  }

  private static Trial linked(
      String name, Trial.Outcome outcome, List<String> fully, List<String> partially) {
    SourceLocation place = new SourceLocation("scenarios/" + name + ".yaml", 0, 0, "", "");
    return new Trial(
        Trial.Kind.SCENARIO,
        name,
        outcome,
        outcome == Trial.Outcome.UNTESTED ? "not tested: nothing was near" : "",
        2,
        List.of(),
        Optional.of(new Trial.Evidence(place, fully, partially)));
  }

  private static Coverage coverage() {
    return new Coverage(
        List.of("model/chain 1.xmi", "rules.ocl"),
        75,
        List.of(
            constraint("SoftwareNode::HasOutput", Severity.ERROR, 2, 4),
            constraint("SoftwareNode::Fast", Severity.WARNING, 3, 4),
            constraint("SoftwareNode::Known", Severity.ERROR, 4, 4),
            constraint("SoftwareNode::Fine", Severity.ERROR, 5, 4),
            constraint("EventChain::Idle", Severity.ERROR, 6, 0),
            new Check(
                Kind.CONTRACT,
                "contract.topic.type",
                "",
                Severity.ERROR,
                SourceLocation.NONE,
                "",
                7)));
  }

  private static Check constraint(String rule, Severity severity, int line, int evaluations) {
    return new Check(
        Kind.CONSTRAINT,
        "ocl.violated",
        rule,
        severity,
        new SourceLocation("rules.ocl", line, 5, "", ""),
        "Fix " + rule + ".",
        evaluations);
  }
}
