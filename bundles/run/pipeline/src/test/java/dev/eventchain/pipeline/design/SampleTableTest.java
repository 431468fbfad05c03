package dev.eventchain.pipeline.design;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.verdict.Curve;
import dev.eventchain.simulation.verdict.FieldSamples;
import dev.eventchain.simulation.verdict.FieldSamples.Form;
import dev.eventchain.simulation.verdict.FieldSamples.Sample;
import dev.eventchain.simulation.verdict.MessageFlow;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Tests the messages that a failed criterion is shown with. */
class SampleTableTest {

  private static final Sample NO_ECHO = new Sample(0, Double.NaN, Double.NaN, 0, 181);

  private static SoftwareNode component(String name, Data input, Data output) {
    SoftwareNode node = EventchainFactory.eINSTANCE.createSoftwareNode();
    node.setName(name);
    node.getInput().add(input);
    node.getOutput().add(output);
    return node;
  }

  private static Data data(String name, String topic, String field) {
    Data data = EventchainFactory.eINSTANCE.createData();
    data.setName(name);
    data.setTopicName(topic);
    data.setFieldName(field);
    return data;
  }

  private static SoftwareNode warning() {
    SoftwareNode node =
        component("Warning", data("ranges", "scan", "ranges"), data("warn", "/warn", "data"));
    node.getInput().add(data("seconds", "/scan", "header.stamp.sec"));
    node.getInput().add(data("limit", "/scan", "range_max"));
    return node;
  }

  private static Sample at(double time, double value) {
    return new Sample(time, value, value, Double.isFinite(value) ? 1 : 0, 1);
  }

  private static Sample at(double time, Sample array) {
    return new Sample(time, array.least(), array.most(), array.finite(), array.size());
  }

  /** Returns scans every 0.1 s up to 2 s, of which the one at 1.5 s has no echo. */
  private static List<Sample> scans() {
    return IntStream.rangeClosed(0, 20)
        .mapToObj(i -> at(i / 10.0, i == 15 ? NO_ECHO : new Sample(0, 20 - i, 30.125, 3 + i, 181)))
        .toList();
  }

  private static List<FieldSamples> samples() {
    List<Sample> warned = new ArrayList<>();
    scans().forEach(it -> warned.add(at(it.time() + 0.02, it.time() < 1.45 ? 0 : 1)));
    List<Sample> limits = scans().stream().map(it -> at(it.time(), 100)).toList();
    List<Sample> seconds = scans().stream().map(it -> at(it.time(), (int) it.time())).toList();
    return List.of(
        new FieldSamples("/warn", "data", "", Form.TRUTH, warned),
        new FieldSamples("/scan", "ranges", "m", Form.ARRAY, scans()),
        new FieldSamples("/scan", "range_max", "m", Form.NUMBER, limits),
        new FieldSamples("/scan", "header.stamp.sec", "s", Form.NUMBER, seconds),
        new FieldSamples("/other", "data", "", Form.NUMBER, limits));
  }

  private static ScenarioVerdict verdict(List<FieldSamples> samples) {
    List<Double> times = IntStream.rangeClosed(0, 40).mapToObj(i -> i / 20.0).toList();
    List<Double> gaps = times.stream().map(it -> 1 / it).toList();
    ScenarioVerdict.Mover ego =
        new ScenarioVerdict.Mover("ego", 4, 2, List.of(), List.of(), List.of());
    return new ScenarioVerdict(
        "s",
        "S",
        List.of(),
        true,
        true,
        false,
        List.of(),
        List.of(),
        List.of(),
        Optional.empty(),
        List.of(),
        new MessageFlow(List.of(), List.of(), List.of()),
        new ScenarioVerdict.Series(
            times,
            List.of(
                new Curve("gap", "m", "", gaps),
                new Curve("/warn.data", "1", "", gaps),
                new Curve("still", "m", "", times.stream().map(it -> 1.0).toList())),
            new ScenarioVerdict.Scene(0, 3.5, 20, List.of(), ego, List.of(), List.of())),
        samples,
        List.of());
  }

  private static CriterionResult decided(double time, Double... otherwise) {
    return new CriterionResult(
        "c",
        true,
        false,
        "m",
        Optional.empty(),
        OptionalDouble.of(time),
        List.of(otherwise),
        List.of(),
        List.of(),
        SourceLocation.NONE,
        List.of(),
        Optional.empty());
  }

  @Test
  void elementsThatAreNoNumbersAreCounted() {
    List<Sample> objects =
        scans().stream()
            .map(it -> new Sample(it.time(), Double.NaN, Double.NaN, 0, it.time() < 1.45 ? 1 : 3))
            .toList();
    FieldSamples field = new FieldSamples("/scan", "ranges", "", Form.LIST, objects);
    String table = SampleTable.of(List.of(warning()), verdict(List.of(field)), decided(1.505));
    assertTrue(table.contains("| 1 element |"), table);
    assertTrue(table.contains("| 3 elements |"), table);
  }

  @Test
  void ofSeveralComponentsSignalsAreShownByTheirTopics() {
    SoftwareNode lamp = component("Lamp", data("on", "/warn", "data"), data("lamp", "/lamp", "on"));
    String table = SampleTable.of(List.of(warning(), lamp), verdict(samples()), decided(1.505));
    assertEquals(
        "| time [s] | /scan.ranges [m] | /warn.data | gap [m] |", table.lines().toList().get(1));
  }

  @Test
  void withoutMessagesTheWorldIsShownAtItsOwnRate() {
    String table = SampleTable.of(List.of(warning()), verdict(List.of()), decided(1.0));
    assertEquals("| time [s] | gap [m] | /warn.data |", table.lines().toList().get(1));
    assertEquals(4 + 17, table.lines().count());
  }

  @Test
  void whereNothingCameThisIsSaid() {
    assertEquals(
        """

        None of these components read or wrote anything that changed from 8.40 s to 9.20 s.

        These never change: input limit is 100 [m].

        """,
        SampleTable.of(List.of(warning()), verdict(samples()), decided(9.0)));
  }

  @Test
  void everyMessageIsShownAndWhatHeldWhenItWasGood() {
    assertEquals(
        """

        | time [s] | input ranges [m] | output warn | gap [m] |
        |---|---|---|---|
        | 0.250 (good) | 18 to 30.13 (5 of 181) | false | 4 |
        | 0.920 |  | false | 1.111 |
        | 1.000 | 10 to 30.13 (13 of 181) | false | 1 |
        | 1.100 | 9 to 30.13 (14 of 181) | false | 0.9091 |
        | 1.200 | 8 to 30.13 (15 of 181) | false | 0.8333 |
        | 1.300 | 7 to 30.13 (16 of 181) | false | 0.7692 |
        | 1.400 | 6 to 30.13 (17 of 181) | false | 0.7143 |
        | 1.500 (decides) | none of 181 | true | 0.6667 |
        | 1.600 | 4 to 30.13 (19 of 181) | true | 0.625 |
        | 1.700 | 3 to 30.13 (20 of 181) | true | 0.5882 |

        These never change: input limit is 100 [m].

        """,
        SampleTable.of(List.of(warning()), verdict(samples()), decided(1.505, 0.25)));
  }
}
