package dev.eventchain.agents;

import static dev.eventchain.agents.JsonMutations.at;
import static dev.eventchain.agents.JsonMutations.edited;
import static dev.eventchain.agents.JsonMutations.path;
import static dev.eventchain.agents.Mutation.equal;
import static dev.eventchain.agents.Mutation.rejected;
import static dev.eventchain.agents.Mutation.visible;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.function.Predicate;

/** Mutations of instance models. */
final class ModelMutations {
  private static final Predicate<Slot> REFERENCE =
      path("/software/\\*/(nextstep|input/\\*|output/\\*|satisfies/\\*)");
  private static final Predicate<Slot> TEXT =
      path(
          "/name|/software/\\*/(name|description)|/data/\\*/(name|description|topicName|messageType|fieldName|type|unit)|/requirements/\\*/text");
  private static final Predicate<Slot> CONTAINED =
      path("/(software|data|requirements)/\\*|/data/\\*/qos");
  private static final Predicate<Slot> WITH_CLASS = path(".*/eClass");
  private static final Predicate<Slot> LITERAL = path("/software/\\*/(origin|implementation)");

  private ModelMutations() {}

  static List<Mutation> all() {
    List<Mutation> all = new ArrayList<>();
    all.addAll(format());
    all.addAll(contents());
    all.addAll(harmless());
    return all;
  }

  private static List<Mutation> format() {
    return List.of(
        rejected(
            "a feature in another case",
            at(
                slot -> slot.parent().isObject() && !path(".*/(id|eClass)").test(slot),
                JsonMutations::inAnotherCase)),
        rejected(
            "a value of another type",
            at(TEXT.or(path(".*/(frequency|eClass)")).or(LITERAL), JsonMutations::ofAnotherType)),
        rejected(
            "a contained object as a text",
            at(CONTAINED, (slot, random) -> slot.set(slot.value().toString()))),
        rejected(
            "an unknown class",
            at(WITH_CLASS, (slot, random) -> slot.set(slot.value().asText() + "Type"))),
        rejected(
            "another class",
            at(
                WITH_CLASS,
                (slot, random) ->
                    slot.set(slot.value().asText().equals("Data") ? "SoftwareNode" : "Data"))),
        rejected(
            "the class of the root is missing",
            edited((root, random) -> ((ObjectNode) root).remove("eClass"))),
        rejected(
            "an unknown literal",
            at(
                LITERAL,
                (slot, random) -> slot.set(slot.value().asText().toLowerCase(Locale.ROOT)))),
        rejected(
            "an id twice",
            at(path("/(software|data)/\\*/id"), (slot, random) -> slot.set("chain"))),
        rejected(
            "a reference to nothing",
            at(REFERENCE, (slot, random) -> slot.set(slot.value().asText() + "_x"))),
        rejected(
            "a reference to something of another class",
            at(REFERENCE, (slot, random) -> slot.set("chain"))),
        rejected(
            "a reference twice",
            at(
                path("/software/\\*/(input|output|satisfies)/\\*"),
                (slot, random) -> ((ArrayNode) slot.parent()).add(slot.value()))));
  }

  private static List<Mutation> contents() {
    return List.of(
        rejected("another text", at(TEXT, (slot, random) -> slot.set(slot.value().asText() + "x"))),
        rejected(
            "another number",
            at(
                path("/software/\\*/frequency"),
                (slot, random) ->
                    slot.set(
                        DoubleNode.valueOf(slot.value().asDouble() + 0.5 + random.nextInt(50))))),
        rejected("another literal", at(LITERAL, ModelMutations::otherLiteral)),
        rejected(
            "a feature is missing",
            at(
                TEXT.or(
                    path(
                        "/software/\\*/(frequency|nextstep|input|output|satisfies)|/data/\\*/qos")),
                (slot, random) -> slot.remove())),
        rejected(
            "an object is left out",
            at(path("/(software|data|requirements)/\\*"), (slot, random) -> slot.remove())),
        rejected("an object more", edited(ModelMutations::addObject)),
        rejected("another next step", edited(ModelMutations::otherNextStep)),
        rejected(
            "external where it is not",
            at(
                path("/data/\\*"),
                (slot, random) ->
                    ((ObjectNode) slot.value())
                        .put("external", !slot.value().path("external").asBoolean()))),
        rejected(
            "a measurement that nobody made",
            at(
                path("/software/\\*"),
                (slot, random) ->
                    ((ObjectNode) slot.value())
                        .putObject("measured")
                        .put("eClass", "NodeMeasurement"))),
        rejected(
            "another profile",
            at(
                path("/data/\\*/qos/name"),
                (slot, random) ->
                    slot.set(
                        slot.value().asText().equals("default") ? "sensor_data" : "default"))));
  }

  private static List<Mutation> harmless() {
    return List.of(
        equal("other ids", ModelMutations::otherIds),
        equal(
            "a contained object without its class",
            at(path("/.*/eClass"), (slot, random) -> slot.remove())),
        equal(
            "a reference as an object",
            at(
                REFERENCE,
                (slot, random) ->
                    slot.set(JsonNodeFactory.instance.objectNode().set("id", slot.value())))),
        equal(
            "null for what is not said",
            at(
                slot -> path("/data/\\*").test(slot) && !slot.value().has("maximumAge"),
                (slot, random) -> ((ObjectNode) slot.value()).putNull("maximumAge"))),
        visible(
            "components in another order",
            edited((root, random) -> swap((ArrayNode) root.get("software"), random))),
        visible(
            "requirements in another order",
            edited((root, random) -> swap((ArrayNode) root.get("requirements"), random))));
  }

  private static void otherLiteral(Slot slot, Random random) {
    String other =
        switch (slot.value().asText()) {
          case "EXISTING" -> "GENERATED";
          case "GENERATED" -> "EXISTING";
          case "NODE" -> "COMPONENT";
          default -> "NODE";
        };
    slot.set(other);
  }

  private static void addObject(JsonNode root, Random random) {
    String feature = List.of("software", "data", "requirements").get(random.nextInt(3));
    ArrayNode array = (ArrayNode) root.get(feature);
    ObjectNode copy = array.get(random.nextInt(array.size())).deepCopy();
    copy.put("id", "copy");
    if (copy.has("qos")) {
      ((ObjectNode) copy.get("qos")).put("id", "copy.qos");
    }
    array.insert(random.nextInt(array.size() + 1), copy);
  }

  private static void otherNextStep(JsonNode root, Random random) {
    ArrayNode software = (ArrayNode) root.get("software");
    ObjectNode node = (ObjectNode) software.get(random.nextInt(software.size()));
    List<String> others = new ArrayList<>();
    software.forEach(each -> others.add(each.path("id").asText()));
    others.remove(node.path("nextstep").asText());
    node.put("nextstep", others.get(random.nextInt(others.size())));
  }

  private static Optional<String> otherIds(GoodAnswer answer, Random random) {
    JsonNode root = answer.json();
    for (Slot slot : Slot.in(root)) {
      boolean named = path("/(software|data)/\\*/id|/data/\\*/qos/id").test(slot);
      if (named || (REFERENCE.test(slot) && !slot.path().contains("satisfies"))) {
        slot.set("id of " + slot.value().asText());
      }
    }
    return Optional.of(answer.with(root));
  }

  private static void swap(ArrayNode array, Random random) {
    int place = random.nextInt(array.size() - 1);
    array.insert(place, array.remove(place + 1));
  }
}
