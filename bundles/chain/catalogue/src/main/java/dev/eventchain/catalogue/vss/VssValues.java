package dev.eventchain.catalogue.vss;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.Signal.NamedNumber;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;

/**
 * The values that a signal may have: listed by {@code allowed} or {@code enum}, which may also give
 * each name a number, in either order.
 *
 * @param texts the values as texts, with their names behind them
 * @param names the names of numbers
 */
record VssValues(List<String> texts, List<NamedNumber> names) {

  private static final String NUMBER = "-?[0-9]+(\\.[0-9]+)?";

  /**
   * Reads the values of a node.
   *
   * @param isText whether the signal is a text, which has a name itself, and not its number
   * @param problems gets what is no such list, and where
   */
  static VssValues of(VssNode node, boolean isText, BiConsumer<String, SourceLocation> problems) {
    VssValues values = new VssValues(new ArrayList<>(), new ArrayList<>());
    node.value("allowed")
        .filter(it -> !values.addListed(it.json()))
        .ifPresent(it -> problems.accept("'allowed' must be a list of values.", it.location()));
    node.value("enum")
        .filter(it -> !values.addListed(it.json()) && !values.addNamed(it.json(), isText))
        .ifPresent(
            it ->
                problems.accept(
                    "'enum' must be a list of values, or give each name a number.", it.location()));
    return values;
  }

  /** Adds the values of a list; returns whether it is one. */
  private boolean addListed(JsonNode list) {
    boolean isList = list.isArray() && !list.isEmpty();
    for (JsonNode each : list) {
      isList = isList && each.isValueNode() && !each.isNull();
    }
    if (isList) {
      list.forEach(each -> texts.add(each.asText()));
    }
    return isList;
  }

  /** Adds the values of a mapping of names and numbers; returns whether it is one. */
  private boolean addNamed(JsonNode mapping, boolean isText) {
    List<NamedNumber> found = new ArrayList<>();
    for (Map.Entry<String, JsonNode> each : mapping.properties()) {
      Optional<NamedNumber> named =
          named(each.getKey(), each.getValue().asText())
              .or(() -> named(each.getValue().asText(), each.getKey()));
      if (named.isEmpty()) {
        return false;
      }
      found.add(named.get());
      String name = named.get().name();
      boolean isFirst = name.equals(each.getKey());
      String number = isFirst ? each.getValue().asText() : each.getKey();
      texts.add(isText ? name : number + " " + name);
    }
    if (!isText) {
      names.addAll(found);
    }
    return !found.isEmpty();
  }

  private static Optional<NamedNumber> named(String name, String number) {
    return !name.isBlank() && number.matches(NUMBER)
        ? Optional.of(new NamedNumber(name, Double.parseDouble(number)))
        : Optional.empty();
  }
}
