package dev.eventchain.simulation.coverage;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.coverage.SignalCoverage.Gap;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Tests what scenarios have shown of signals, and which gaps are found. */
class CoverageRecordTest {

  private static final MessageCatalog CATALOG =
      MessageCatalog.ofTexts(
          Map.of(
              "demo_msgs/msg/Objects",
              "float32[] distance\nfloat32[] width\nuint32[] id\n",
              "demo_msgs/msg/Driver",
              """
              uint8 GEAR_PARK=0
              uint8 GEAR_DRIVE=1
              uint8 GEAR_REVERSE=2
              uint8 MODE_OFF=0
              uint8 MODE_NONE=0
              uint8 MODE_ON=1
              std_msgs/Header header
              uint8 gear
              uint8 mode
              bool left
              bool right
              float32 yaw_rate
              float32 limit
              """,
              "demo_msgs/msg/Warning",
              """
              bool left_lamp
              bool right_lamp
              bool unread
              float32 brake
              """));

  private static final Bench BENCH =
      Bench.parse(
          SourceText.of(
              "bench.yaml",
              """
              inputs:
                gear: {value: 0}
                yaw: {unit: rad/s, value: 0}
              provides:
                /objects:
                  rate_hz: 20
                  type: demo_msgs/msg/Objects
                  objects:
                    range_m: 100
                    fields: {distance: {value: distance, unit: m}, width: {value: width, unit: m}, id: id}
                /driver:
                  rate_hz: 20
                  type: demo_msgs/msg/Driver
                  fields:
                    gear: gear
                    left: gear > 5
                    right: gear > 6
                    yaw_rate: {value: yaw, unit: rad/s}
                    limit: {constant: 3}
              consumes:
                /warning:
                  type: demo_msgs/msg/Warning
                  fields:
                    brake: {drives: brake}
              """),
          List.of(),
          CATALOG);

  private final EventChain chain = EventchainFactory.eINSTANCE.createEventChain();
  private final SoftwareNode node = EventchainFactory.eINSTANCE.createSoftwareNode();
  private final List<CoverageRecord> records = new ArrayList<>();

  CoverageRecordTest() {
    Requirement requirement = EventchainFactory.eINSTANCE.createRequirement();
    requirement.setId("W-1");
    chain.getRequirements().add(requirement);
    node.setName("Warner");
    node.setImplementation(ComponentImplementation.COMPONENT);
    node.getSatisfies().add(requirement);
    chain.getSoftware().add(node);
  }

  private void input(String topic, String type, String field, String unit) {
    node.getInput().add(data(topic, type, field, unit));
  }

  private void output(String field) {
    node.getOutput().add(data("/warning", "demo_msgs/msg/Warning", field, ""));
  }

  private Data data(String topic, String type, String field, String unit) {
    Data data = EventchainFactory.eINSTANCE.createData();
    data.setName(field);
    data.setTopicName(topic);
    data.setMessageType(type);
    data.setFieldName(field);
    data.setUnit(unit);
    chain.getData().add(data);
    return data;
  }

  private SimulatedChain simulated() {
    return new SimulatedChain(chain, BENCH, CATALOG, false, Set.of());
  }

  /** Adds a scenario in which a field has these values. */
  private void scenario(String topic, String type, String field, Object... values) {
    CoverageRecord record = new CoverageRecord(simulated());
    for (Object value : values) {
      record.add(topic, MessageValue.of(CATALOG.find(type).orElseThrow()).set(field, value));
    }
    records.add(record);
  }

  private void warning(String field, Object... values) {
    scenario("/warning", "demo_msgs/msg/Warning", field, values);
  }

  private void driver(String field, Object... values) {
    scenario("/driver", "demo_msgs/msg/Driver", field, values);
  }

  private void objects(String field, Object... values) {
    scenario("/objects", "demo_msgs/msg/Objects", field, values);
  }

  /** Returns the values of each signal, its episodes and its gaps. */
  private List<String> found() {
    return CoverageRecord.of(simulated(), records, List.of()).stream()
        .map(
            each ->
                String.format(
                    Locale.ROOT,
                    "%s: %s, %d; %s",
                    each.name(),
                    each.shown(),
                    each.episodes(),
                    each.gaps().stream().map(Gap::words).collect(Collectors.joining("; "))))
        .toList();
  }

  private List<String> kinds() {
    return CoverageRecord.of(simulated(), records, List.of()).stream()
        .flatMap(each -> each.gaps().stream())
        .map(each -> each.kind().name())
        .toList();
  }

  /** A component that reads what the other one writes. */
  private void reader(String field) {
    SoftwareNode reader = EventchainFactory.eINSTANCE.createSoftwareNode();
    reader.setName("Reader");
    reader.setImplementation(ComponentImplementation.COMPONENT);
    reader.getInput().add(data("/warning", "demo_msgs/msg/Warning", field, ""));
    chain.getSoftware().add(reader);
  }

  @Test
  void aWarningThatNeverComesAgainIsFound() {
    output("left_lamp");
    reader("left_lamp");
    warning("left_lamp", false, true, true, false);
    warning("left_lamp", true, false);
    assertEquals(List.of("/warning.left_lamp: false, true, 1; a second time"), found());
    warning("left_lamp", false, true, false, true);
    assertEquals(List.of("/warning.left_lamp: false, true, 2; "), found());
  }

  @Test
  void theOtherOfTwoLampsIsFoundAlthoughNobodyReadsIt() {
    output("left_lamp");
    output("right_lamp");
    output("unread");
    reader("left_lamp");
    warning("left_lamp", false, true, false, true);
    assertEquals(
        List.of(
            "/warning.left_lamp: false, true, 2; ",
            "/warning.right_lamp: false, 0; true",
            "/warning.unread: false, 0; "),
        found());
  }

  @Test
  void aBrakeIsReleasedForMoreThanAMomentBeforeItIsAnotherOne() {
    output("brake");
    Object[] flickers =
        IntStream.range(0, 40).mapToObj(i -> (Object) (i < 10 || i % 3 == 0 ? 0.0 : 0.5)).toArray();
    warning("brake", flickers);
    assertEquals(List.of("/warning.brake: 0 to 0.5, 1; a second time"), found());
    warning("brake", 1, 1, 0, 0, 0, 0, 0, 1);
    assertEquals(List.of("/warning.brake: 0 to 1, 2; "), found());
  }

  @Test
  void aNumberThatNeverRestsHasNoEpisodes() {
    output("brake");
    warning("brake", 0, 0.3, 0.4, 0.5, 0.6);
    assertEquals(List.of("/warning.brake: 0 to 0.6, 0; "), found());
  }

  @Test
  void valuesThatNeverCameAreFound() {
    input("/driver", "demo_msgs/msg/Driver", "gear", "");
    input("/driver", "demo_msgs/msg/Driver", "left", "");
    input("/driver", "demo_msgs/msg/Driver", "limit", "");
    input("/driver", "demo_msgs/msg/Driver", "header.stamp.sec", "");
    driver("gear", 0, 1, 1);
    assertEquals(
        List.of(
            "/driver.gear: GEAR_PARK, GEAR_DRIVE, 1; GEAR_REVERSE",
            "/driver.left: false, 0; true",
            "/driver.limit: 0, 0; "),
        found());
    driver("gear", 2);
    driver("left", true);
    assertTrue(kinds().isEmpty(), () -> found().toString());
  }

  /** A number may have two constants, as in the actions of a marker. */
  @Test
  void aValueWithTwoNamesHasBoth() {
    input("/driver", "demo_msgs/msg/Driver", "mode", "");
    driver("mode", 0, 1);
    assertEquals(List.of("/driver.mode: MODE_OFF, MODE_NONE, MODE_ON, 1; "), found());
  }

  @Test
  void oneSideOfANumberIsFoundUnlessTheOtherOneIsClear() {
    input("/driver", "demo_msgs/msg/Driver", "yaw_rate", "rad/s");
    driver("yaw_rate", -0.001, 0.02, 0.06);
    assertEquals(
        List.of("/driver.yaw_rate: -0.001 to 0.06 rad/s, 0; below 0, but -0.001 to 0.06 rad/s"),
        found());
    driver("yaw_rate", -0.02);
    assertEquals(List.of(), kinds());
  }

  @Test
  void listsWithOneObjectAndColumnsThatNeverChangeAreFound() {
    input("/objects", "demo_msgs/msg/Objects", "distance", "m");
    input("/objects", "demo_msgs/msg/Objects", "id", "");
    objects("distance", List.of(), List.of(40.0), List.of(40.0));
    assertEquals(
        List.of(
            "/objects.distance: 0 to 1 element, 0; a second element",
            "/objects.distance[]: 40 m, 0; anything but 40 m",
            "/objects.id: 0 elements, 0; an element"),
        found());
    objects("distance", List.of(40.0, 50.0));
    objects("id", List.of(7L, 7L));
    assertEquals(List.of(), kinds());
  }

  @Test
  void nothingIsSaidOfComponentsThatNoRequirementIsAbout() {
    node.getSatisfies().clear();
    output("brake");
    input("/driver", "demo_msgs/msg/Driver", "left", "");
    driver("left", false);
    assertEquals(List.of(), kinds());
  }

  @Test
  void withoutARecordThereAreNoSignals() {
    output("brake");
    assertEquals(List.of(), found());
  }
}
