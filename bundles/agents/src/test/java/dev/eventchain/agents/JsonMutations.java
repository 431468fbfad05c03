package dev.eventchain.agents;

import static dev.eventchain.agents.Mutation.equal;
import static dev.eventchain.agents.Mutation.rejected;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.BooleanNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.node.TextNode;
import dev.eventchain.agents.Mutation.Change;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/** Mutations of JSON answers. */
final class JsonMutations {
  private static final Pattern LINE_WITH_KEY = Pattern.compile("(?m)^ *\"\\w+\": [^\\[{\\n]*,\\n");
  private static final Pattern NUMBER = Pattern.compile("(?<=: )-?[0-9.]+(?=,?\\n)");
  private static final Pattern COMMA = Pattern.compile(",\\n");
  private static final Pattern TEXT = Pattern.compile("(?<=: \")[A-Za-z ]{2,}");

  private JsonMutations() {}

  /** Returns the mutations for JSON of any task. */
  static List<Mutation> all() {
    List<Mutation> all = new ArrayList<>();
    all.addAll(syntax());
    all.addAll(layout());
    return all;
  }

  private static List<Mutation> syntax() {
    return List.of(
        rejected("a comma is missing", replaced(COMMA, (found, random) -> "\n")),
        rejected("a comma too many", replaced(COMMA, (found, random) -> ",,\n")),
        rejected("a property twice", replaced(LINE_WITH_KEY, (line, random) -> line + line)),
        rejected("a number is NaN", replaced(NUMBER, (number, random) -> "NaN")),
        rejected("a number has its unit", replaced(NUMBER, (number, random) -> number + " Hz")),
        rejected("a number in words", replaced(NUMBER, (number, random) -> "twenty")),
        rejected("a line break in a string", replaced(TEXT, (text, random) -> text + "\n")),
        rejected("a control character", replaced(TEXT, (text, random) -> text + "\\u0007")),
        rejected(
            "dots for the rest",
            replaced(COMMA, (comma, random) -> random.nextBoolean() ? ",\n...\n" : "...\n")),
        rejected(
            "a closing bracket is missing",
            replaced(Pattern.compile("[\\]}](?=,?\\n)"), (bracket, random) -> "")),
        rejected(
            "the whole as a text",
            (answer, random) ->
                Optional.of(answer.withBlock(TextNode.valueOf(answer.block()).toString()))));
  }

  private static List<Mutation> layout() {
    return List.of(
        equal(
            "compact", (answer, random) -> Optional.of(answer.withBlock(answer.json().toString()))),
        equal("keys in another order", edited((root, random) -> shuffle(root, random))),
        equal("comments", replaced(COMMA, (comma, random) -> ", // \"as\" before\n")),
        equal(
            "a trailing comma",
            replaced(Pattern.compile("\\n(?= *[\\]}])"), (end, random) -> ",\n")),
        equal(
            "escapes",
            replaced(
                TEXT,
                (text, random) ->
                    String.format(Locale.ROOT, "\\u%04x", (int) text.charAt(0))
                        + text.substring(1))));
  }

  private static void shuffle(JsonNode node, Random random) {
    if (node instanceof ObjectNode object) {
      List<String> keys = new ArrayList<>();
      object.fieldNames().forEachRemaining(keys::add);
      Collections.shuffle(keys, random);
      keys.forEach(key -> object.set(key, object.remove(key)));
    }
    node.forEach(child -> shuffle(child, random));
  }

  /** Changes one match of a pattern in the block. */
  static Change replaced(Pattern pattern, BiFunction<String, Random, String> by) {
    return (answer, random) -> {
      String block = answer.block();
      List<MatchResult> places = pattern.matcher(block).results().toList();
      if (places.isEmpty()) {
        return Optional.empty();
      }
      MatchResult place = places.get(random.nextInt(places.size()));
      return Optional.of(
          answer.withBlock(
              block.substring(0, place.start())
                  + by.apply(place.group(), random)
                  + block.substring(place.end())));
    };
  }

  /** Changes the root. */
  static Change edited(BiConsumer<JsonNode, Random> edit) {
    return (answer, random) -> {
      JsonNode root = answer.json();
      edit.accept(root, random);
      return Optional.of(answer.with(root));
    };
  }

  /** Changes one of the matching places. */
  static Change at(Predicate<Slot> wanted, BiConsumer<Slot, Random> edit) {
    return atNew((slot, existing) -> wanted.test(slot), edit);
  }

  /** As {@link #at}, with a condition that may depend on whether the component exists. */
  static Change atNew(Wanted wanted, BiConsumer<Slot, Random> edit) {
    return (answer, random) -> {
      JsonNode root = answer.json();
      List<Slot> slots =
          Slot.in(root).stream()
              .filter(slot -> wanted.test(slot, isExisting(root, slot, answer)))
              .toList();
      if (slots.isEmpty()) {
        return Optional.empty();
      }
      edit.accept(slots.get(random.nextInt(slots.size())), random);
      return Optional.of(answer.with(root));
    };
  }

  /** A condition on places. */
  @FunctionalInterface
  interface Wanted {
    boolean test(Slot slot, boolean existing);
  }

  private static boolean isExisting(JsonNode root, Slot slot, GoodAnswer answer) {
    return root instanceof ArrayNode
        && answer
            .existing()
            .contains(root.path(Integer.parseInt(slot.root())).path("name").asText());
  }

  static Predicate<Slot> path(String regex) {
    Pattern pattern = Pattern.compile(regex);
    return slot -> pattern.matcher(slot.path()).matches();
  }

  /** Replaces the value by one of another type. */
  static void ofAnotherType(Slot slot, Random random) {
    JsonNode value = slot.value();
    if (value.isTextual()) {
      slot.set(BooleanNode.TRUE);
    } else if (value.isContainerNode() || random.nextBoolean()) {
      slot.set(value.toString());
    } else {
      slot.set(JsonNodeFactory.instance.objectNode().set("value", value));
    }
  }

  /** Writes a key in another case. */
  static void inAnotherCase(Slot slot, Random random) {
    String key = slot.key();
    String upper = key.substring(0, 1).toUpperCase(Locale.ROOT) + key.substring(1);
    String[] others = {upper, key.toUpperCase(Locale.ROOT), key + "s", "_" + key};
    slot.rename(others[random.nextInt(others.length)]);
  }
}
