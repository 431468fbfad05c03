package dev.eventchain.simulation.fault;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.scenario.CriteriaReader;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.FormulasReader;
import dev.eventchain.simulation.scenario.NamedRequirements;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.world.World;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/** Reads a file with faults. */
final class FaultsReader {

  private static final DocumentRules RULES =
      new DocumentRules(
          FaultRules.FAULT_SYNTAX,
          FaultRules.FAULT_KEY_DUPLICATE,
          FaultRules.FAULT_VALUE_TYPE,
          FaultRules.FAULT_KEY_MISSING,
          FaultRules.FAULT_KEY_UNKNOWN,
          FaultRules.FAULT_VALUE_RANGE);
  private static final NumberRange SECONDS = NumberRange.of(0, 600);
  private static final NumberRange LENGTH = NumberRange.of(0.001, 600);
  private static final double ALL = 100;

  private final SourceText text;
  private final FaultTargets targets;
  private final Bench bench;
  private final List<Scenario> scenarios;
  private final List<Diagnostic> problems = new ArrayList<>();
  private final Map<String, SourceLocation> names = new HashMap<>();

  /** Interval in which a fault is active, in ns. */
  private record Window(long start, long end) {}

  /** Kind, target and amount of a fault. */
  private record What(FaultKind kind, String target, long amount) {}

  FaultsReader(SourceText text, FaultTargets targets, Bench bench, List<Scenario> scenarios) {
    this.text = text;
    this.targets = targets;
    this.bench = bench;
    this.scenarios = scenarios;
  }

  FaultPlan read() {
    Document document = Document.parse(text, DocumentFormat.YAML, RULES, problems::add);
    List<Fault> faults = new ArrayList<>();
    document
        .object("", problems::add)
        .ifPresent(
            section -> {
              List<ObjectReader> parts = section.requiredObjects("faults");
              parts.forEach(part -> faults.addAll(fault(part)));
              section.refuseOthers();
              if (problems.isEmpty() && parts.isEmpty()) {
                String message = "There is no fault in this list.";
                section.find(FaultRules.FAULT_NONE, message, section.atKey("faults"));
              }
            });
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    return new FaultPlan(faults);
  }

  /** Reads a fault, once for each of its scenarios. */
  private List<Fault> fault(ObjectReader section) {
    String name = name(section);
    List<Scenario> where = scenariosOf(section);
    Optional<What> what = what(section);
    Window window = window(section, where, what);
    double shortest = where.stream().mapToDouble(Scenario::duration).min().orElse(SECONDS.most());
    Optional<ObjectReader> expect = section.object("expect");
    List<Expectation> criteria = new ArrayList<>();
    Optional<Fault.Detected> detection = expect.flatMap(FaultsReader::detection);
    expect.ifPresent(part -> criteria.addAll(criteria(part, shortest, detection.isPresent())));
    section.refuseOthers();
    return what.stream()
        .flatMap(
            it ->
                where.stream()
                    .map(
                        scenario ->
                            new Fault(
                                name,
                                scenario,
                                it.kind(),
                                it.target(),
                                window.start(),
                                window.end(),
                                it.amount(),
                                criteria,
                                detection,
                                section.atKey("name"))))
        .toList();
  }

  private String name(ObjectReader section) {
    String name = section.requiredText("name");
    if (!name.isBlank() && !name.matches("[a-z0-9]+(-[a-z0-9]+)*")) {
      String message = "A name consists of lower-case letters, digits and hyphens.";
      section.find(FaultRules.FAULT_VALUE_RANGE, message, section.at("name"));
    }
    SourceLocation earlier = names.putIfAbsent(name, section.at("name"));
    if (earlier != null && !name.isBlank()) {
      section.find(
          Diagnostic.of(
                  FaultRules.FAULT_NAME_DUPLICATE,
                  "The name " + name + " is taken by the fault in line " + earlier.line() + ".",
                  section.at("name"))
              .withHint("Give each fault its own name; reports use it."));
    }
    return name;
  }

  /** Returns the scenarios that a fault names: one, or a list. */
  private List<Scenario> scenariosOf(ObjectReader section) {
    boolean list = section.value("scenario").filter(JsonNode::isArray).isPresent();
    List<String> wanted =
        list ? section.texts("scenario") : List.of(section.requiredText("scenario"));
    if (list && wanted.isEmpty()) {
      section.find(FaultRules.FAULT_KEY_MISSING, "'scenario' names none.", section.at("scenario"));
    }
    List<Scenario> found = new ArrayList<>();
    List<String> known = scenarios.stream().map(Scenario::name).toList();
    for (String name : wanted.stream().distinct().toList()) {
      scenarios.stream().filter(it -> it.name().equals(name)).findFirst().ifPresent(found::add);
      if (!name.isBlank() && !known.contains(name)) {
        unknown(section, "scenario", "scenario", name, known);
      }
    }
    return found;
  }

  private static void unknown(
      ObjectReader section, String key, String what, String name, Collection<String> known) {
    section.find(
        Diagnostic.of(
                FaultRules.FAULT_UNKNOWN,
                "There is no " + what + " '" + name + "'.",
                section.at(key))
            .withHint(NearestName.hint(name, known)));
  }

  private Optional<What> what(ObjectReader section) {
    List<FaultKind> kinds = new ArrayList<>();
    for (FaultKind kind : FaultKind.values()) {
      if (section.has(kind.key())) {
        kinds.add(kind);
      }
    }
    if (kinds.size() == 1) {
      return Optional.of(what(section, kinds.get(0)));
    }
    String all = String.join(", ", FaultKind.keys());
    SourceLocation place = kinds.isEmpty() ? section.location() : section.atKey(kinds.get(1).key());
    String message =
        kinds.isEmpty()
            ? "This fault does not say what is wrong."
            : "A fault is one thing, not "
                + kinds.get(0).key()
                + " and "
                + kinds.get(1).key()
                + ".";
    section.find(
        Diagnostic.of(FaultRules.FAULT_KIND, message, place)
            .withHint("Write one of these: " + all + "."));
    return Optional.empty();
  }

  private What what(ObjectReader section, FaultKind kind) {
    if (kind.target() == FaultKind.Target.NOTHING) {
      double jump = section.requiredNumber(kind.key(), kind.range());
      if (jump == 0) {
        String message = "A jump of 0 ms is not a jump.";
        section.find(FaultRules.FAULT_VALUE_RANGE, message, section.at(kind.key()));
      }
      return new What(kind, "", amount(kind, jump));
    }
    String key = kind.target() == FaultKind.Target.NODE ? "node" : "topic";
    boolean simple = kind.target() == FaultKind.Target.NODE && !kind.hasAmount();
    if (simple || kind.target() == FaultKind.Target.SENSOR) {
      return new What(kind, target(section, kind.key(), kind), 0);
    }
    Optional<ObjectReader> part = section.object(kind.key());
    String target = part.map(it -> target(it, key, kind)).orElse("");
    double amount = part.filter(it -> kind.hasAmount()).map(it -> number(it, kind)).orElse(0.0);
    part.ifPresent(ObjectReader::refuseOthers);
    return new What(kind, target, amount(kind, amount));
  }

  /** Returns the amount as written; by default, all messages are lost. */
  private static double number(ObjectReader part, FaultKind kind) {
    if (kind == FaultKind.DROP) {
      return part.number(kind.amount(), kind.range()).orElse(ALL);
    }
    return kind == FaultKind.DELAY
        ? part.requiredNumber(kind.amount(), kind.range())
        : part.requiredWholeNumber(kind.amount(), kind.range());
  }

  private static long amount(FaultKind kind, double written) {
    return Math.round(written * kind.unit());
  }

  private String target(ObjectReader section, String key, FaultKind kind) {
    String name = section.requiredText(key);
    Collection<String> known =
        switch (kind.target()) {
          case NODE -> targets.nodes();
          case SENSOR -> targets.sensors();
          default -> targets.topics();
        };
    if (!name.isBlank() && !known.contains(name)) {
      String what =
          switch (kind.target()) {
            case NODE -> "simulated node";
            case SENSOR -> "topic of a sensor";
            default -> "topic that the world or a simulated node writes,";
          };
      unknown(section, key, what, name, known);
    }
    return name;
  }

  private static Window window(ObjectReader section, List<Scenario> where, Optional<What> what) {
    double start = section.requiredNumber("at_s", SECONDS);
    OptionalDouble length = section.number("for_s", LENGTH);
    for (Scenario scenario : where) {
      if (start >= scenario.duration()) {
        String message = "The scenario " + scenario.name() + " ends before this.";
        section.find(FaultRules.FAULT_VALUE_RANGE, message, section.at("at_s"));
      }
    }
    if (length.isPresent() && what.filter(it -> it.kind() == FaultKind.KILL).isPresent()) {
      section.find(
          Diagnostic.of(
                  FaultRules.FAULT_KIND,
                  "A process that was killed does not come back.",
                  section.atKey("for_s"))
              .withHint("Leave for_s out, or write stop instead of kill."));
    }
    long from = World.nanoseconds(start);
    what.filter(it -> it.kind() == FaultKind.CLOCK_JUMP && from + it.amount() < 0)
        .ifPresent(
            it -> {
              String message = "The clock would show a time before the start of the scenario.";
              section.find(FaultRules.FAULT_VALUE_RANGE, message, section.at(it.kind().key()));
            });
    long end = length.isPresent() ? from + World.nanoseconds(length.getAsDouble()) : RunLog.NEVER;
    return new Window(from, end);
  }

  private static Optional<Fault.Detected> detection(ObjectReader part) {
    part.requireTrue("detected");
    OptionalDouble within = part.number("detected_within_s", SECONDS);
    if (within.isPresent()) {
      return Optional.of(new Fault.Detected(within, part.atKey("detected_within_s")));
    }
    return part.has("detected")
        ? Optional.of(new Fault.Detected(OptionalDouble.empty(), part.atKey("detected")))
        : Optional.empty();
  }

  private List<Expectation> criteria(ObjectReader part, double shortest, boolean detection) {
    FormulasReader formulas =
        new FormulasReader(
            text, bench.signals(), shortest, NamedRequirements.none(), Optional.empty());
    List<Expectation> criteria = CriteriaReader.readWritten(part, formulas);
    part.refuseOthers();
    if (criteria.isEmpty() && !detection && problems.isEmpty()) {
      String message = "Nothing is expected: write a criterion of scenarios, or detected: true.";
      part.find(FaultRules.FAULT_KEY_MISSING, message, part.location());
    }
    return criteria;
  }
}
