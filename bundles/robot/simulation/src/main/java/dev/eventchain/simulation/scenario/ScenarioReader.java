package dev.eventchain.simulation.scenario;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.formula.ActorSignals;
import dev.eventchain.simulation.formula.Range;
import dev.eventchain.simulation.world.Script;
import dev.eventchain.simulation.world.Situation;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;

/** Reads scenario files, with units in the names of the keys, into SI units. */
final class ScenarioReader {

  private static final DocumentRules RULES =
      new DocumentRules(
          ScenarioRules.SYNTAX,
          ScenarioRules.KEY_DUPLICATE,
          ScenarioRules.VALUE_TYPE,
          ScenarioRules.KEY_MISSING,
          ScenarioRules.KEY_UNKNOWN,
          ScenarioRules.VALUE_RANGE);
  private static final NumberRange DURATION = NumberRange.of(0.1, 600);
  private static final NumberRange SEED = NumberRange.of(0, 1L << 52);

  private ScenarioReader() {}

  static Scenario read(SourceText text, Bench bench, boolean varying) {
    List<Diagnostic> problems = new ArrayList<>();
    Document document = Document.parse(text, DocumentFormat.YAML, RULES, problems::add);
    Optional<Scenario> scenario =
        document
            .object("", problems::add)
            .map(section -> scenario(section, text, bench, varying, problems::isEmpty));
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    return scenario.orElseThrow();
  }

  /**
   * Reads a scenario.
   *
   * @param varying whether formulas are refused that are true or false in every run
   * @param sound returns whether there is no problem yet
   */
  private static Scenario scenario(
      ObjectReader section, SourceText text, Bench bench, boolean varying, BooleanSupplier sound) {
    String name = name(section);
    section.text("description"); // for people
    String title = section.requiredText("title");
    NamedRequirements requirements = NamedRequirements.ofScenario(section);
    long seed = section.wholeNumber("seed", SEED).orElse(1);
    double duration = section.requiredNumber("duration_s", DURATION);
    SituationReader reader = new SituationReader(section, text, bench, longest(section));
    Situation situation = reader.read();
    Map<String, Script> inputs =
        section.object("inputs").map(part -> InputsReader.read(part, bench)).orElse(Map.of());
    FormulasReader formulas =
        new FormulasReader(
            text,
            new ActorSignals(bench.signals(), SituationReader.names(situation.actors())),
            longest(section),
            requirements,
            Optional.<Range.Source>of(new SignalRanges(situation, inputs, bench, longest(section)))
                .filter(ranges -> varying));
    NodePhases phases = section.object("phases_ms").map(NodePhases::read).orElse(NodePhases.NONE);
    Scenario.Asked asked = asked(section, formulas);
    if (sound.getAsBoolean()) { // A criterion with an error may be the one that needs an input.
      InputsReader.requireUse(section, reader.notAwaited(inputs.keySet()), asked, bench);
    }
    section.refuseOthers();
    Scenario.Heading heading =
        new Scenario.Heading(
            name, title, requirements.all(), requirements.places(), section.location());
    return new Scenario(heading, seed, duration, situation, inputs, phases, asked);
  }

  private static Scenario.Asked asked(ObjectReader section, FormulasReader formulas) {
    List<Expectation> criteria =
        section
            .requiredObject("accept")
            .map(part -> CriteriaReader.read(part, formulas))
            .orElse(List.of());
    NamedRequirements requirements = formulas.requirements();
    return new Scenario.Asked(
        requirements.distributed(criteria),
        formulas.readObserved(section),
        requirements.judged(),
        formulas.optional().locations());
  }

  private static String name(ObjectReader section) {
    String name = section.requiredText("name");
    if (!name.matches("[a-z0-9]+(-[a-z0-9]+)*") && !name.isBlank()) {
      String message = "A name consists of lower-case letters, digits and hyphens.";
      section.find(ScenarioRules.VALUE_RANGE, message, section.at("name"));
    }
    return name;
  }

  /**
   * Returns the duration; the maximum if it is invalid, so that no interval is rejected because of
   * it.
   */
  private static double longest(ObjectReader section) {
    return section
        .value("duration_s")
        .map(JsonNode::doubleValue)
        .filter(seconds -> seconds >= DURATION.least() && seconds <= DURATION.most())
        .orElse(DURATION.most());
  }
}
