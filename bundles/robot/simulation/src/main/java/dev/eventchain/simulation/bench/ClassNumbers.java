package dev.eventchain.simulation.bench;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.simulation.formula.NamedValues;
import dev.eventchain.simulation.world.ActorKind;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;

/** Reads the numbers that a message has for the kinds of objects: {@code {car: 1, other: 0}}. */
final class ClassNumbers {

  private static final NumberRange NUMBER = NumberRange.of(-128, 65535);

  /** The key for all kinds that are not named. */
  private static final String OTHER = "other";

  private static final List<String> IDS =
      Arrays.stream(ActorKind.values()).map(ActorKind::id).toList();

  private ClassNumbers() {}

  /**
   * Returns a number for each kind.
   *
   * @param names constants of the message, which may stand for numbers
   */
  static Map<ActorKind, Integer> read(ObjectReader section, NamedValues names) {
    int other = (int) number(section, OTHER, names).orElse(0);
    Map<ActorKind, Integer> numbers = new EnumMap<>(ActorKind.class);
    Arrays.stream(ActorKind.values()).forEach(kind -> numbers.put(kind, other));
    for (String name : section.names()) {
      Optional<ActorKind> kind =
          Arrays.stream(ActorKind.values()).filter(each -> each.id().equals(name)).findFirst();
      if (kind.isPresent()) {
        number(section, name, names).ifPresent(number -> numbers.put(kind.get(), (int) number));
      } else if (!name.equals(OTHER)) {
        section.value(name);
        section.find(
            Diagnostic.of(
                    BenchRules.BENCH_VALUE_RANGE,
                    "There is no kind of object '" + name + "'.",
                    section.atKey(name))
                .withHint(
                    NearestName.of(name, IDS)
                        .map(nearest -> "Did you mean '" + nearest + "'?")
                        .orElse("The kinds are: " + String.join(", ", IDS) + ", other.")));
      }
    }
    return numbers;
  }

  private static OptionalLong number(ObjectReader section, String kind, NamedValues names) {
    Optional<JsonNode> value = section.value(kind).filter(JsonNode::isTextual);
    if (value.isEmpty() || names.isEmpty()) {
      return section.wholeNumber(kind, NUMBER);
    }
    String text = value.get().textValue();
    if (FieldNames.numbered(text, names) instanceof Long number) {
      return OptionalLong.of(number);
    }
    Diagnostic finding =
        Diagnostic.of(
            BenchRules.BENCH_VALUE_RANGE,
            "The message has no constant '" + text + "'.",
            section.at(kind));
    section.find(FieldNames.hinted(finding, text, names));
    return OptionalLong.empty();
  }
}
