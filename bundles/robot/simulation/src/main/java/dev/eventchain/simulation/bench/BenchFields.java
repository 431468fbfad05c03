package dev.eventchain.simulation.bench;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.Unit;
import dev.eventchain.simulation.bench.Bench.Field;
import dev.eventchain.simulation.bench.Bench.Source;
import dev.eventchain.simulation.formula.Condition;
import dev.eventchain.simulation.formula.Formula;
import dev.eventchain.simulation.formula.FormulaParser;
import dev.eventchain.simulation.formula.NamedValues;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.formula.Term;
import dev.eventchain.simulation.formula.WorldSignals;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** Reads the connections of single fields of a bench's topics. */
final class BenchFields {

  private static final String VALUE = "value";
  private static final String CONSTANT = "constant";
  private static final String TEXTS = "texts";
  private static final String ABSENT = "absent";

  /** Message for a value that is not a string, a number, a Boolean or a list. */
  static final String NO_VALUE = "This is not a value that a field can have.";

  private static final String UNIT = "unit";
  private static final String NOISE = "noise";

  private final DeclaredSignals declared;
  private final YamlText source;
  private final Signal.Source signals;

  /**
   * Creates a reader.
   *
   * @param inputs the inputs that values may depend on besides the world
   */
  BenchFields(DeclaredSignals declared, Collection<Signal> inputs, YamlText source) {
    this.declared = declared;
    this.source = source;
    this.signals = new Known(List.copyOf(inputs));
  }

  /** Signals of the world and of the inputs. */
  private record Known(List<Signal> inputs) implements Signal.Source {

    @Override
    public Optional<Signal> find(String name) {
      return Stream.concat(WorldSignals.all().stream(), inputs.stream())
          .filter(each -> each.name().equals(name))
          .findFirst();
    }

    @Override
    public Collection<String> names() {
      return Stream.concat(WorldSignals.all().stream(), inputs.stream()).map(Signal::name).toList();
    }
  }

  /**
   * Reads the connection of a published field; returns empty after a finding if it is invalid.
   *
   * @param message the type of the topic's messages, if known
   */
  Optional<Field> read(
      ObjectReader part, String topic, String path, Optional<MessageType> message) {
    Optional<FieldType> type = type(part, path, message);
    JsonNode value = part.value(path).orElse(null);
    if (value == null) {
      part.find(BenchRules.BENCH_VALUE_RANGE, NO_VALUE, part.at(path));
    }
    if (value == null || (message.isPresent() && type.isEmpty())) {
      return Optional.empty();
    }
    Optional<Source> found;
    if (value.isTextual()) {
      found =
          source(
              part, path, value.textValue(), unit(part, Optional.empty(), topic, path), 0.0, type);
    } else if (value.isObject()) {
      found = part.object(path).flatMap(section -> written(section, topic, path, type));
    } else {
      found = Optional.of(constant(value));
    }
    NamedValues names = FieldNames.of(declared, topic, () -> message, path);
    found =
        found.map(
            it ->
                it instanceof Bench.Constant constant
                    ? new Bench.Constant(FieldNames.numbered(constant.value(), names))
                    : it);
    found.ifPresent(it -> declared.check(part, topic, path, it));
    found = found.filter(it -> fits(part, path, it, message, names));
    return found.map(it -> new Field(path, it, part.atKey(path)));
  }

  /** Returns the type of a field; reports a missing one as a finding. */
  static Optional<FieldType> type(ObjectReader part, String path, Optional<MessageType> message) {
    if (message.isEmpty()) {
      return Optional.empty();
    }
    MessageType.Resolution found = message.get().resolve(path);
    if (found.type().isEmpty()) {
      part.find(
          Diagnostic.of(BenchRules.MESSAGE_FIELD_MISSING, found.problem(), part.atKey(path))
              .withHint(found.hint()));
    }
    return found.type();
  }

  private Optional<Source> written(
      ObjectReader section, String topic, String path, Optional<FieldType> type) {
    if (section.has(VALUE) == section.has(CONSTANT)) {
      String message = "A field has either '" + VALUE + "' or '" + CONSTANT + "'.";
      section.find(BenchRules.BENCH_KEY_MISSING, message, section.location());
    }
    double absent = section.number(ABSENT, NumberRange.of(-1e12, 1e12)).orElse(0.0);
    Optional<String> unitText = section.text(UNIT);
    double noise = section.number(NOISE, NumberRange.of(0, 1e6)).orElse(0.0);
    Optional<Source> found =
        section.has(CONSTANT)
            ? constant(section)
            : section.has(TEXTS)
                ? chosen(section, type)
                : section
                    .text(VALUE)
                    .flatMap(
                        text ->
                            source(
                                section,
                                VALUE,
                                text,
                                unit(section, unitText, topic, path),
                                absent,
                                type));
    section.refuseOthers();
    return withNoise(section, found, noise);
  }

  private static Optional<Source> withNoise(
      ObjectReader section, Optional<Source> found, double noise) {
    if (noise > 0.0 && found.isPresent() && !(found.get() instanceof Bench.Quantity)) {
      section.find(
          BenchRules.BENCH_VALUE_RANGE, "Only a quantity can have noise.", section.at(NOISE));
    }
    return found.map(source -> source instanceof Bench.Quantity it ? it.withNoise(noise) : source);
  }

  /** Reads a quantity whose values stand for texts. */
  private Optional<Source> chosen(ObjectReader section, Optional<FieldType> type) {
    List<String> texts = section.texts(TEXTS);
    Optional<Term> number = part(section, VALUE, "'%s' is not a number without a unit.");
    for (String key : List.of(UNIT, ABSENT)) {
      if (section.has(key)) {
        String message = "A text has no '" + key + "'.";
        section.find(BenchRules.BENCH_VALUE_RANGE, message, section.at(key));
      }
    }
    if (texts.size() < 2 || texts.size() != Set.copyOf(texts).size()) {
      String message = "'" + TEXTS + "' must be at least two different strings.";
      section.find(BenchRules.BENCH_VALUE_RANGE, message, section.at(TEXTS));
      return Optional.empty();
    }
    if (type.isPresent() && !isText(type.get())) {
      String message = "The field is %s, which holds no text.".formatted(type.get());
      section.find(BenchRules.BENCH_VALUE_TYPE, message, section.at(TEXTS));
      return Optional.empty();
    }
    return number.map(term -> new ChosenText(section.text(VALUE).orElse(""), term, texts));
  }

  private static boolean isText(FieldType type) {
    return type.kind() == FieldType.Kind.STRING && type.shape() == FieldType.Shape.SINGLE;
  }

  private static Optional<Source> constant(ObjectReader section) {
    Optional<JsonNode> constant = section.value(CONSTANT);
    if (constant.isEmpty()) {
      section.find(BenchRules.BENCH_VALUE_RANGE, NO_VALUE, section.at(CONSTANT));
    }
    section.value(VALUE);
    return constant.map(BenchFields::constant);
  }

  private static Bench.Constant constant(JsonNode value) {
    return new Bench.Constant(plain(value));
  }

  /** Returns whether a value is a string, a Boolean, a finite number, or a list of these. */
  private static boolean isPlain(Object value) {
    if (value instanceof List<?> list) {
      return list.stream().allMatch(BenchFields::isPlain);
    }
    return value instanceof String
        || value instanceof Boolean
        || (value instanceof Number number && Double.isFinite(number.doubleValue()));
  }

  static Object plain(JsonNode value) {
    if (value.isArray()) {
      List<Object> values = new ArrayList<>();
      value.forEach(each -> values.add(plain(each)));
      return values;
    }
    return value.isNumber()
        ? value.numberValue()
        : value.isBoolean()
            ? (Object) value.booleanValue()
            : value.isTextual() ? value.textValue() : value;
  }

  /** Checks that a constant can be the field's value. */
  private static boolean fits(
      ObjectReader part,
      String path,
      Source source,
      Optional<MessageType> message,
      NamedValues names) {
    if (source instanceof Bench.Constant constant && !isPlain(constant.value())) {
      part.find(BenchRules.BENCH_VALUE_RANGE, NO_VALUE, part.at(path));
      return false;
    }
    if (message.isPresent() && source instanceof Bench.Constant constant) {
      try {
        Object set = MessageValue.of(message.get()).set(path, constant.value()).get(path);
        if (set instanceof Float number && number.isInfinite()) {
          throw new IllegalArgumentException(constant.value() + " is out of the range of float32.");
        }
      } catch (IllegalArgumentException e) {
        Diagnostic finding =
            Diagnostic.of(BenchRules.BENCH_VALUE_TYPE, e.getMessage(), part.at(path));
        part.find(FieldNames.hinted(finding, constant.value(), names));
        return false;
      }
    }
    return true;
  }

  /**
   * Returns the unit of a field, as stated by the bench or the project, which must agree.
   *
   * @return the unit as written; empty if none is stated or it is invalid
   */
  Optional<String> unit(ObjectReader section, Optional<String> written, String topic, String path) {
    Optional<String> known = declared.unit(topic, path);
    if (written.isPresent() && BenchInputs.unit(section, written.get()).isEmpty()) {
      return Optional.empty();
    }
    if (written.isEmpty() && known.isPresent() && known.flatMap(Unit::parse).isEmpty()) {
      section.find(notUnderstood(section.at(path), topic, path, known.get()));
      return Optional.empty();
    }
    boolean differs =
        written.isPresent()
            && known.flatMap(Unit::parse).isPresent()
            && known.flatMap(Unit::parse).get().relationTo(Unit.parse(written.get()).orElseThrow())
                != Unit.Relation.SAME;
    if (differs) {
      String field = "'" + path + "' of " + topic;
      section.find(BenchInputs.differing(section, field, written.get(), known.get()));
    }
    return written.or(() -> known).filter(text -> Unit.parse(text).isPresent());
  }

  /**
   * Creates the finding on an unknown unit; read as a plain number, the field would be off by a
   * factor.
   */
  private static Diagnostic notUnderstood(
      SourceLocation place, String topic, String path, String unit) {
    return Diagnostic.of(
            BenchRules.BENCH_UNIT,
            "signals.json gives '%s' of %s the unit '%s', which is not understood."
                .formatted(path, topic, unit),
            place)
        .withHint("Write a unit such as m/s, km/h, % or 1 into signals.json.");
  }

  /** Reads a quantity or a condition for a field. */
  private Optional<Source> source(
      ObjectReader section,
      String key,
      String text,
      Optional<String> unit,
      double absent,
      Optional<FieldType> type) {
    SourceLocation place = section.at(key);
    FormulaParser.Part part;
    try {
      part = FormulaParser.parseMoment(source.range(place, text), signals);
    } catch (DiagnosticException e) {
      e.diagnostics().forEach(section::find);
      return Optional.empty();
    }
    boolean truth = part instanceof Condition || (part instanceof Term it && it.truth());
    if (type.isPresent() && !takes(type.get(), truth)) {
      boolean isTruth = type.get().kind() == FieldType.Kind.BOOL;
      section.find(
          Diagnostic.of(
                  BenchRules.BENCH_VALUE_TYPE,
                  "'%s' is %s, but the field is %s."
                      .formatted(text, truth ? "true or false" : "a quantity", type.get()),
                  place)
              .withHint(
                  isTruth
                      ? "Write a condition, such as `gap < 100 m`."
                      : "Give it a constant: {constant: ...}."));
      return Optional.empty();
    }
    return truth
        ? Optional.of(new Bench.Truth(text, Formula.ofMoment(part, text)))
        : quantity(section, place, text, (Term) part, unit, absent);
  }

  /** Returns whether a field can hold a Boolean, or else a number. */
  static boolean takes(FieldType type, boolean truth) {
    return BenchSignals.isNumberOrTruth(type) && (type.kind() == FieldType.Kind.BOOL) == truth;
  }

  /**
   * Reads a fraction as a quantity without a unit; returns empty if it is invalid.
   *
   * @param key the key of the formula
   */
  Optional<Term> part(ObjectReader section, String key) {
    return part(section, key, "'%s' is not a fraction, such as 5 %%.");
  }

  private Optional<Term> part(ObjectReader section, String key, String otherwise) {
    Optional<String> text = section.text(key);
    if (text.isEmpty()) {
      return Optional.empty();
    }
    SourceLocation place = section.at(key);
    try {
      FormulaParser.Part part = FormulaParser.parseMoment(source.range(place, text.get()), signals);
      if (part instanceof Term term
          && !term.truth()
          && BenchInputs.fits(term, Unit.parse("1").orElseThrow())) {
        return Optional.of(term);
      }
      section.find(BenchRules.BENCH_UNIT, otherwise.formatted(text.get()), place);
    } catch (DiagnosticException e) {
      e.diagnostics().forEach(section::find);
    }
    return Optional.empty();
  }

  private static Optional<Source> quantity(
      ObjectReader section,
      SourceLocation place,
      String text,
      Term term,
      Optional<String> unitText,
      double absent) {
    Unit plain = Unit.parse("1").orElseThrow();
    Optional<Unit> unit = unitText.flatMap(Unit::parse);
    boolean needsNone = term.dimension().relationTo(plain) == Unit.Relation.SAME;
    if (unit.isEmpty() && !needsNone) {
      section.find(
          Diagnostic.of(
                  BenchRules.BENCH_UNIT,
                  "Nothing says in which unit '" + text + "' is sent.",
                  place)
              .withHint("Write the field's unit into signals.json, or {value: ..., unit: m/s}."));
      return Optional.empty();
    }
    if (unit.isPresent() && !BenchInputs.fits(term, unit.get())) {
      section.find(
          Diagnostic.of(
              BenchRules.BENCH_UNIT,
              "'%s' cannot be sent in %s.".formatted(text, unitText.get()),
              place));
      return Optional.empty();
    }
    return Optional.of(new Bench.Quantity(text, term, unit.orElse(plain), absent, 0.0));
  }
}
