package dev.eventchain.agents;

import static dev.eventchain.agents.JsonMutations.at;
import static dev.eventchain.agents.JsonMutations.atNew;
import static dev.eventchain.agents.JsonMutations.edited;
import static dev.eventchain.agents.JsonMutations.path;
import static dev.eventchain.agents.Mutation.rejected;
import static dev.eventchain.agents.Mutation.visible;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DecimalNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.NullNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;

/** Mutations of designed chains. */
final class DesignMutations {
  private static final String PORT = "/\\*/(input|output)/\\*";
  private static final String VALUE = PORT + "/values/\\*";
  private static final Predicate<Slot> REQUIRED =
      path(
          "/\\*/(name|frequency)|"
              + PORT
              + "/(topic|message_type|values)|"
              + VALUE
              + "/(name|field)");
  private static final List<String> NO_NAMES =
      List.of(
          "",
          " ",
          "class",
          "self",
          "a b",
          "a-b",
          "1st",
          "../a",
          "[a/]",
          "\"",
          "'; import os",
          "a\nb",
          "__init__",
          "\u00e4",
          "None",
          "${a}",
          "a.b");
  private static final List<String> NO_NUMBERS = List.of("0", "-20", "20001", "1e400");

  private DesignMutations() {}

  static List<Mutation> all() {
    List<Mutation> all = new ArrayList<>();
    all.addAll(format());
    all.addAll(contracts());
    all.addAll(harmless());
    return all;
  }

  private static List<Mutation> format() {
    return List.of(
        rejected("a required key is missing", at(REQUIRED, (slot, random) -> slot.remove())),
        rejected(
            "null for a required value",
            at(REQUIRED, (slot, random) -> slot.set(NullNode.instance))),
        rejected(
            "a key in another case",
            at(slot -> slot.parent().isObject(), JsonMutations::inAnotherCase)),
        rejected(
            "a value of another type",
            at(path(".*(?<!/safe_value)(?<!/qos_profile)"), JsonMutations::ofAnotherType)),
        rejected(
            "a type is missing",
            atNew(
                (slot, old) -> !old && path(VALUE + "/type").test(slot),
                (slot, random) -> slot.remove())),
        rejected(
            "no name",
            at(
                path("/\\*/name|" + VALUE + "/name"),
                (slot, random) -> slot.set(any(NO_NAMES, random)))),
        rejected(
            "no frequency",
            at(
                path("/\\*/frequency"),
                (slot, random) -> slot.set(number(any(NO_NUMBERS, random))))),
        rejected("a component twice", at(path("/\\*"), DesignMutations::repeat)),
        rejected("a value twice", at(path(VALUE), DesignMutations::repeat)),
        rejected("an object around", DesignMutations::wrapped),
        rejected(
            "a message type without its package",
            at(
                path(PORT + "/message_type"),
                (slot, random) -> slot.set(slot.value().asText().replaceFirst(".*/", "")))));
  }

  private static List<Mutation> contracts() {
    return List.of(
        rejected(
            "an unknown requirement",
            at(
                path("/\\*/requirements/\\*"),
                (slot, random) -> slot.set(slot.value().asText() + "9"))),
        rejected(
            "an invented topic",
            at(
                path("/\\*/input/\\*/topic"),
                (slot, random) -> slot.set("/invented" + slot.value().asText()))),
        rejected(
            "an invented message type",
            at(
                path(PORT + "/message_type"),
                (slot, random) -> slot.set(slot.value().asText() + "Stamped2"))),
        rejected(
            "another message type",
            at(path(PORT + "/message_type"), (slot, random) -> slot.set("std_msgs/msg/Header"))),
        rejected(
            "an invented field",
            at(path(VALUE + "/field"), (slot, random) -> slot.set(slot.value().asText() + "_x"))),
        rejected(
            "another type of a field",
            at(
                path(VALUE + "/type"),
                (slot, random) ->
                    slot.set(slot.value().asText().equals("float64") ? "float32" : "float64"))),
        rejected("another unit", at(path(VALUE + "/unit"), DesignMutations::otherUnit)),
        rejected("a component is left out", at(path("/\\*"), (slot, random) -> slot.remove())),
        rejected(
            "an input of an existing component is left out",
            atNew(
                (slot, old) -> old && path("/\\*/input/\\*").test(slot),
                (slot, random) -> slot.remove())),
        rejected(
            "another frequency of an existing component",
            atNew(
                (slot, old) -> old && path("/\\*/frequency").test(slot),
                (slot, random) ->
                    slot.set(DoubleNode.valueOf(slot.value().asDouble() + 1 + random.nextInt(9))))),
        rejected(
            "a budget of memory below zero",
            at(path("/\\*"), (slot, random) -> ((ObjectNode) slot.value()).put("memory", -1.0))));
  }

  private static List<Mutation> harmless() {
    return List.of(
        visible(
            "another description",
            at(
                path(".*/description"),
                (slot, random) -> slot.set(slot.value().asText() + " Or not."))),
        visible(
            "another frequency of a new component",
            atNew(
                (slot, old) -> !old && path("/\\*/frequency").test(slot),
                (slot, random) ->
                    slot.set(
                        DoubleNode.valueOf(slot.value().asDouble() + 1 + random.nextInt(60))))),
        visible(
            "another name of a value of a new component",
            atNew(
                (slot, old) -> !old && path(VALUE + "/name").test(slot),
                (slot, random) -> slot.set(slot.value().asText() + "_" + random.nextInt(100)))),
        visible(
            "an age of an input",
            atNew(
                (slot, old) -> !old && path("/\\*/input/\\*/values/\\*").test(slot),
                (slot, random) ->
                    ((ObjectNode) slot.value()).put("maximum_age", 5000.0 + random.nextInt(1000)))),
        visible("a requirement more", edited(DesignMutations::addRequirement)),
        visible("two components in another order", edited(DesignMutations::swap)));
  }

  private static <T> T any(List<T> list, Random random) {
    return list.get(random.nextInt(list.size()));
  }

  private static JsonNode number(String text) {
    return DecimalNode.valueOf(new BigDecimal(text));
  }

  private static void repeat(Slot slot, Random random) {
    ((ArrayNode) slot.parent()).insert(Integer.parseInt(slot.key()), slot.value().deepCopy());
  }

  private static Optional<String> wrapped(GoodAnswer answer, Random random) {
    ObjectNode around = JsonNodeFactory.instance.objectNode();
    around.set("event_chain", answer.json());
    return Optional.of(answer.with(around));
  }

  private static void otherUnit(Slot slot, Random random) {
    List<String> units =
        new ArrayList<>(List.of("ms", "s", "Hz", "km/h", "m/s", "m", "cm", "rad", "deg", "%"));
    units.remove(slot.value().asText());
    slot.set(any(units, random));
  }

  private static void addRequirement(JsonNode root, Random random) {
    Set<String> ids = new TreeSet<>();
    root.forEach(component -> component.path("requirements").forEach(id -> ids.add(id.asText())));
    JsonNode component = root.get(random.nextInt(root.size()));
    component.path("requirements").forEach(id -> ids.remove(id.asText()));
    ids.stream().findFirst().ifPresent(((ArrayNode) component.path("requirements"))::add);
  }

  private static void swap(JsonNode root, Random random) {
    int place = random.nextInt(root.size() - 1);
    ArrayNode array = (ArrayNode) root;
    array.insert(place, array.remove(place + 1));
  }
}
