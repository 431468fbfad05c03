package dev.eventchain.simulation.bench;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.ModelChange;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.formula.FormulaParser;
import dev.eventchain.simulation.formula.FormulaTokens;
import dev.eventchain.simulation.formula.SampledRun;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.formula.Term;
import dev.eventchain.simulation.formula.WorldSignals;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Collection;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntToDoubleFunction;

/**
 * Reads the inputs of a bench: values that a scenario may script, and values computed from others.
 * Each input is read when another one needs it, so their order in the file does not matter.
 */
final class BenchInputs implements Signal.Source {

  private static final WorldSignals WORLD = new WorldSignals();
  private static final String FORMULA = "formula";
  private static final String VALUE = "value";
  private static final String UNIT = "unit";
  private static final int DEEPEST = 50;
  private static final NumberRange ANY = NumberRange.of(-1e12, 1e12);

  private final ObjectReader section;
  private final YamlText source;
  private final Map<String, Signal> known = new LinkedHashMap<>();
  private final Deque<String> reading = new ArrayDeque<>();

  /** Inputs with an error of their own. */
  private final Set<String> refused = new HashSet<>();

  /** The end of reading an input that needs a refused one, whose error alone is reported. */
  private static final class Consequence extends RuntimeException {
    private static final long serialVersionUID = 1L;

    Consequence(String input) {
      super("needs " + input, null, false, false);
    }
  }

  private BenchInputs(ObjectReader section, YamlText source) {
    this.section = section;
    this.source = source;
  }

  /** Reads all inputs in the order of the file; invalid ones are left out. */
  static Map<String, Signal> read(ObjectReader section, YamlText source) {
    BenchInputs inputs = new BenchInputs(section, source);
    Map<String, Signal> ordered = new LinkedHashMap<>();
    for (String name : section.names()) {
      try {
        inputs.input(name).ifPresent(signal -> ordered.put(name, signal));
      } catch (DiagnosticException e) {
        e.diagnostics().forEach(section::find);
        inputs.refuseAll();
      } catch (Consequence e) {
        inputs.refuseAll();
      }
    }
    return ordered;
  }

  /** Refuses the inputs that are being read, since each needs the next one. */
  private void refuseAll() {
    refused.addAll(reading);
    reading.clear();
  }

  @Override
  public Collection<String> names() {
    Set<String> names = new LinkedHashSet<>(WORLD.names());
    names.addAll(section.names());
    return names;
  }

  @Override
  public Optional<Signal> find(String name) {
    return WORLD.find(name).or(() -> needed(name));
  }

  /** Returns an input that another one needs. */
  private Optional<Signal> needed(String name) {
    if (!section.names().contains(name)) {
      return Optional.empty();
    }
    Optional<Signal> signal = input(name);
    if (signal.isEmpty()) {
      throw new Consequence(name);
    }
    return signal;
  }

  /** Returns an input, which is read first if necessary; empty if it has an error. */
  private Optional<Signal> input(String name) {
    if (known.containsKey(name) || refused.contains(name)) {
      return Optional.ofNullable(known.get(name));
    }
    if (reading.contains(name)) {
      throw cycle(name);
    }
    if (reading.size() > DEEPEST) {
      throw new DiagnosticException(
          DiagnosticException.Reason.INPUT,
          Diagnostic.of(
              BenchRules.BENCH_VALUE_RANGE,
              "More than " + DEEPEST + " inputs are computed from one another.",
              section.atKey(name)));
    }
    reading.addLast(name);
    Optional<Signal> signal = section.object(name).flatMap(input -> input(name, input));
    reading.removeLast();
    signal.ifPresentOrElse(found -> known.put(name, found), () -> refused.add(name));
    return signal;
  }

  private DiagnosticException cycle(String name) {
    List<String> names = reading.stream().dropWhile(each -> !each.equals(name)).toList();
    String message = "The input '%s' is computed from itself: %s needs %s.";
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(
                BenchRules.BENCH_INPUT_CYCLE,
                message.formatted(name, String.join(" needs ", names), name),
                section.atKey(name))
            .withHint("Give one of them a value."));
  }

  private Optional<Signal> input(String name, ObjectReader input) {
    checkName(name);
    String unitText = input.text(UNIT).orElse("1");
    Optional<Unit> unit = unit(input, unitText);
    if (input.has(FORMULA) == input.has(VALUE)) {
      String message = "An input has either '" + VALUE + "' or '" + FORMULA + "'.";
      input.find(BenchRules.BENCH_KEY_MISSING, message, input.location());
    }
    double value = input.number(VALUE, ANY).orElse(0.0);
    boolean computed = input.has(FORMULA);
    Optional<String> formula = input.text(FORMULA);
    input.refuseOthers();
    if (unit.isEmpty() || (computed && formula.isEmpty())) {
      return Optional.empty();
    }
    return computed
        ? term(input, formula.get(), unit.get()).map(term -> computed(name, unitText, term))
        : Optional.of(scripted(name, unitText, unit.get().coherent(value)));
  }

  private void checkName(String name) {
    if (WORLD.find(name).isPresent()) {
      String message = "The world already has a '" + name + "'.";
      section.find(BenchRules.BENCH_VALUE_RANGE, message, section.atKey(name));
    } else if (!FormulaTokens.isName(name)) {
      String message = "No formula can name an input '" + name + "'.";
      section.find(BenchRules.BENCH_VALUE_RANGE, message, section.atKey(name));
    }
  }

  /** Returns a unit by its name; reports an unknown one as a finding. */
  static Optional<Unit> unit(ObjectReader section, String text) {
    Optional<Unit> unit = Unit.parse(text);
    if (unit.isEmpty()) {
      section.find(
          Diagnostic.of(BenchRules.BENCH_UNIT, "There is no unit '" + text + "'.", section.at(UNIT))
              .withHint(Unit.respelled(text).map(it -> "Did you mean `" + it + "`?").orElse("")));
    }
    return unit;
  }

  /** Returns the finding that a section states another unit than the project, with the change. */
  static Diagnostic differing(ObjectReader section, String field, String written, String known) {
    SourceLocation place = section.at(UNIT);
    String title = "Change the unit to '" + known + "', as in signals.json";
    return Diagnostic.of(
            BenchRules.BENCH_UNIT,
            "%s is in %s here, but in %s in signals.json.".formatted(field, written, known),
            place)
        .withHint("Leave one of them out, or write the same unit.")
        .withChanges(List.of(new ModelChange(title, place, "", UNIT, written, known, false)));
  }

  private Optional<Term> term(ObjectReader input, String text, Unit unit) {
    FormulaParser.Part part =
        FormulaParser.parseMoment(source.range(input.at(FORMULA), text), this);
    if (part instanceof Term term && fits(term, unit)) {
      return Optional.of(term);
    }
    String message = "'" + text + "' is not a quantity in " + input.text(UNIT).orElse("1") + ".";
    input.find(BenchRules.BENCH_UNIT, message, input.at(FORMULA));
    return Optional.empty();
  }

  /** Returns whether the values of a quantity can be converted to a unit. */
  static boolean fits(Term term, Unit unit) {
    Unit.Relation relation = term.dimension().relationTo(unit);
    return relation == Unit.Relation.SAME || relation == Unit.Relation.CONVERTIBLE;
  }

  private static Signal scripted(String name, String unit, double usual) {
    return new Signal(
        name,
        unit,
        false,
        BenchSignals.SCRIPTED,
        trace ->
            trace.states().stream()
                .mapToDouble(
                    state -> trace.input(name).map(it -> it.at(state.time())).orElse(usual))
                .toArray(),
        trace -> Optional.empty());
  }

  private static Signal computed(String name, String unit, Term term) {
    return new Signal(
        name,
        unit,
        false,
        "computed",
        trace -> {
          IntToDoubleFunction values = term.values().in(new SampledRun(trace));
          double[] samples = new double[trace.states().size()];
          Arrays.setAll(samples, values);
          return samples;
        },
        term::absence,
        term.signals(),
        term::range);
  }
}
