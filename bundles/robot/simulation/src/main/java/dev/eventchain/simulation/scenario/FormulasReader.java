package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.bench.YamlText;
import dev.eventchain.simulation.formula.Formula;
import dev.eventchain.simulation.formula.Range;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.formula.UnresolvedOutputException;
import dev.eventchain.simulation.scenario.FormulaCriterion.Form;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Reads the formulas in the section {@code accept} of a scenario. */
public final class FormulasReader {

  private static final String KEY = "formula";

  private final YamlText source;
  private final Signal.Source signals;
  private final double duration;
  private final NamedRequirements requirements;
  private final OptionalCriteria optional = new OptionalCriteria();
  private final Optional<Range.Source> ranges;

  /**
   * Creates a reader.
   *
   * @param source the file, for the locations of problems
   * @param signals the signals that the formulas may read
   * @param duration of the scenario, in s
   * @param requirements reads the requirements that formulas name
   * @param ranges the values that signals can have, to reject formulas that cannot be otherwise;
   *     empty to allow these
   */
  public FormulasReader(
      SourceText source,
      Signal.Source signals,
      double duration,
      NamedRequirements requirements,
      Optional<Range.Source> ranges) {
    this.ranges = ranges;
    this.source = new YamlText(source);
    this.signals = signals;
    this.duration = duration;
    this.requirements = requirements;
  }

  /** Reads formulas with their names and requirements. */
  List<Expectation> read(List<ObjectReader> sections) {
    List<Expectation> criteria = new ArrayList<>();
    for (ObjectReader section : sections) {
      String name = section.text("name").orElse("").strip();
      if (!section.has(KEY)) {
        String message = "'" + KEY + "' is missing.";
        section.find(ScenarioRules.KEY_MISSING, message, section.location());
      }
      List<String> tested = tested(section, KEY);
      section
          .text(KEY)
          .flatMap(
              text ->
                  criterion(
                      section,
                      KEY,
                      name,
                      Form.WRITTEN,
                      source.range(section.at(KEY), text),
                      tested))
          .ifPresent(criteria::add);
      section.refuseOthers();
    }
    return criteria;
  }

  /** Reads the formulas of a scenario that are reported, and not judged. */
  List<Expectation> readObserved(ObjectReader scenario) {
    FormulasReader observed =
        new FormulasReader(
            source.source(), signals, duration, NamedRequirements.none(), Optional.empty());
    return observed.read(scenario.objects("observe"));
  }

  /** Reads what makes a run the test that a scenario describes. */
  List<Expectation> readConditions(ObjectReader scenario) {
    FormulasReader conditions =
        new FormulasReader(source.source(), signals, duration, NamedRequirements.none(), ranges);
    return conditions.read(scenario.objects("test_conditions"));
  }

  /**
   * Reads the requirements that an entry of a list names or judges, and whether it is optional.
   *
   * @param key the key at which the criterion is located
   */
  List<String> tested(ObjectReader entry, String key) {
    optional.ofEntry(entry, entry.atKey(key));
    return requirements.ofEntry(entry, entry.atKey(key));
  }

  /** Returns the reader of which criteria are optional. */
  OptionalCriteria optional() {
    return optional;
  }

  /** Returns the reader of the requirements that criteria name. */
  NamedRequirements requirements() {
    return requirements;
  }

  /** Returns the duration of the scenario, in s. */
  double duration() {
    return duration;
  }

  /**
   * Parses a criterion whose formula is derived from a key; problems are reported at the key.
   *
   * @param key the key of the section from which the formula is derived
   * @param form what it asks for
   * @param tested ids of the requirements that it names
   */
  Optional<Expectation> parse(
      ObjectReader section, String key, String name, Form form, String text, List<String> tested) {
    SourceRange range = SourceText.within(section.at(key), text).whole();
    return criterion(section, key, name, form, range, tested);
  }

  private Optional<Expectation> criterion(
      ObjectReader section,
      String key,
      String name,
      Form form,
      SourceRange range,
      List<String> tested) {
    SourceLocation place = section.atKey(key);
    try {
      return formula(section, key, range)
          .map(formula -> new FormulaCriterion(name, formula, form, place, tested));
    } catch (UnresolvedOutputException e) {
      String text = range.text().strip().replaceAll("\\s+", " ");
      return Optional.of(
          new UnresolvedCriterion(
              name.isEmpty() ? text : name + " (" + text + ")", e.getMessage(), place, tested));
    }
  }

  private Optional<Formula> formula(ObjectReader section, String key, SourceRange range) {
    try {
      return Optional.of(
          ranges.isPresent()
              ? Formula.parse(range, signals, duration, ranges.get())
              : Formula.parse(range, signals, duration));
    } catch (DiagnosticException e) {
      for (Diagnostic problem : e.diagnostics()) {
        SourceLocation place = problem.location().withElement(section.pointerTo(key));
        section.find(problem.withLocation(place));
      }
      return Optional.empty();
    }
  }
}
