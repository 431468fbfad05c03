package dev.eventchain.pipeline.campaign.plan;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DecimalNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.documents.Document;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The way to a number in a file: keys from the top, with {@code [2]} or {@code [name]} for an
 * element of a list. A key may have dots itself: the longest one that is there counts. One that is
 * not there is added.
 */
public final class NumberPath {

  /** Beginning of the paths of numbers of the bench. */
  public static final String BENCH = "bench:";

  private static final Pattern STEP = Pattern.compile("([^.\\[\\]]+)|\\[([^\\[\\]]+)]");
  private static final Pattern INDEX = Pattern.compile("\\d{1,6}");

  private final String path;
  private final List<String> steps;

  public NumberPath(String path) {
    this.path = path;
    this.steps = steps(path);
  }

  /** Returns the keys and {@code [...]} of a path; none if it is no path. */
  private static List<String> steps(String path) {
    List<String> steps = new ArrayList<>();
    Matcher step = STEP.matcher(path);
    int end = 0;
    while (step.find()) {
      String between = path.substring(end, step.start());
      boolean joined = between.isEmpty() ? step.group(1) == null || end == 0 : between.equals(".");
      if (!joined) {
        return List.of();
      }
      steps.add(step.group(1) != null ? step.group(1) : step.group());
      end = step.end();
    }
    return end == path.length() ? steps : List.of();
  }

  /** A place for a number: what owns it, and its key. */
  public record Place(ObjectNode owner, String key) {

    public void set(BigDecimal value) {
      owner.set(key, DecimalNode.valueOf(value));
    }
  }

  /** A path that leads to no number. */
  public static final class WrongPathException extends Exception {

    private static final long serialVersionUID = 1L;

    WrongPathException(String message) {
      super(message);
    }
  }

  /**
   * Returns where it leads in a file.
   *
   * @throws WrongPathException with the reason, for users
   */
  public Place in(ObjectNode root) throws WrongPathException {
    return in(root, NumberPath::value, NumberPath::named);
  }

  /** Returns what a path leads to, without adding anything; empty if there is nothing. */
  Optional<JsonNode> find(ObjectNode root, BiFunction<ArrayNode, String, JsonNode> named) {
    try {
      Place place = in(root, (owner, key, following) -> owner.get(key), named);
      return Optional.ofNullable(place.owner().get(place.key()));
    } catch (WrongPathException e) {
      return Optional.empty();
    }
  }

  /** Lookup of the value of a key, in front of a step. */
  private interface Values {
    JsonNode of(ObjectNode owner, String key, String following);
  }

  private Place in(ObjectNode root, Values values, BiFunction<ArrayNode, String, JsonNode> named)
      throws WrongPathException {
    if (steps.isEmpty()) {
      throw new WrongPathException("'" + path + "' is no path, such as actors[0].gap_m.");
    }
    JsonNode node = root;
    int at = 0;
    while (at < steps.size()) {
      String step = steps.get(at);
      if (isElement(step)) {
        node = require(node, element(node, step, named), step);
        at++;
      } else if (node instanceof ObjectNode owner) {
        int next = endOfKey(owner, at);
        String key = String.join(".", steps.subList(at, next));
        if (next == steps.size()) {
          return place(owner, key);
        }
        node = values.of(owner, key, steps.get(next));
        at = next;
      } else {
        node = null;
      }
      if (node == null) {
        throw new WrongPathException("There is no " + step + " for the path '" + path + "'.");
      }
    }
    throw new WrongPathException("'" + path + "' is not the path of a number.");
  }

  /** Returns an element of a list; if it is none, what is there is said. */
  private JsonNode require(JsonNode list, JsonNode element, String step) throws WrongPathException {
    if (element != null || !(list instanceof ArrayNode)) {
      return element;
    }
    List<String> known = new ArrayList<>();
    for (JsonNode each : list) {
      known.add("[" + each.path("name").asText(String.valueOf(known.size())) + "]");
    }
    throw new WrongPathException(
        "There is no %s for the path '%s', %s."
            .formatted(
                step,
                path,
                known.isEmpty() ? "the list is empty" : "but " + String.join(", ", known)));
  }

  /** Returns where it leads, as a JSON pointer; empty if it leads to no number. */
  public Optional<String> pointer(ObjectNode root) {
    ObjectNode copy = root.deepCopy();
    try {
      Place place = in(copy);
      return pointer(copy, place.owner()).map(it -> Document.below(it, place.key()));
    } catch (WrongPathException e) {
      return Optional.empty();
    }
  }

  /** Returns the way from a node to one in it. */
  @SuppressWarnings("ReferenceEquality") // equal nodes stand in many places
  private static Optional<String> pointer(JsonNode from, JsonNode to) {
    if (from == to) {
      return Optional.of("");
    }
    Map<String, JsonNode> children = new LinkedHashMap<>();
    from.properties().forEach(each -> children.put(each.getKey(), each.getValue()));
    for (JsonNode each : from instanceof ArrayNode list ? list : List.<JsonNode>of()) {
      children.put(String.valueOf(children.size()), each);
    }
    return children.entrySet().stream()
        .flatMap(
            each ->
                pointer(each.getValue(), to)
                    .map(it -> Document.below("", each.getKey()) + it)
                    .stream())
        .findFirst();
  }

  private Place place(ObjectNode owner, String key) throws WrongPathException {
    JsonNode before = owner.get(key);
    if (before != null && !before.isNumber()) {
      throw new WrongPathException("'" + path + "' is not the path of a number.");
    }
    return new Place(owner, key);
  }

  private static boolean isElement(String step) {
    return step.startsWith("[");
  }

  /** Returns the end of the longest key that is there, from a step on; one step if none is. */
  private int endOfKey(ObjectNode owner, int from) {
    int end = from + 1;
    for (int to = from + 1; to <= steps.size() && !isElement(steps.get(to - 1)); to++) {
      end = owner.has(String.join(".", steps.subList(from, to))) ? to : end;
    }
    return end;
  }

  private static JsonNode value(ObjectNode owner, String key, String following) {
    if (!owner.has(key) && !isElement(following)) {
      owner.putObject(key);
    }
    return owner.get(key);
  }

  private static JsonNode element(
      JsonNode node, String step, BiFunction<ArrayNode, String, JsonNode> named) {
    String which = step.substring(1, step.length() - 1).strip();
    if (!(node instanceof ArrayNode list)) {
      return null;
    }
    return INDEX.matcher(which).matches()
        ? list.get(Integer.parseInt(which))
        : named.apply(list, which);
  }

  private static JsonNode named(ArrayNode list, String which) {
    for (JsonNode each : list) {
      if (each.path("name").asText().equals(which)) {
        return each;
      }
    }
    return null;
  }
}
