package dev.eventchain.simulation.strength;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.simulation.fault.OutputFault;
import dev.eventchain.simulation.fault.OutputFault.Change;
import dev.eventchain.simulation.fault.OutputFault.Range;
import dev.eventchain.simulation.verdict.Strength;
import dev.eventchain.simulation.verdict.Strength.LeftOut;
import dev.eventchain.simulation.verdict.Strength.Reaction;
import dev.eventchain.simulation.verdict.Strength.Requirement;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import org.junit.jupiter.api.Test;

/** Tests that the first faults are a sample of all. */
class SampleOrderTest {

  private static final List<Change> OF_FIELDS =
      List.of(Change.STUCK, Change.INVERTED, Change.SCALED, Change.SHIFTED, Change.NOISY);

  /** Returns the faults of two components with two fields each, one component after the other. */
  private static List<OutputFault> faults() {
    List<OutputFault> faults = new ArrayList<>();
    for (String node : List.of("Gap", "Speed")) {
      for (Change change : List.of(Change.FIRST, Change.DROPPED, Change.DELAYED)) {
        faults.add(fault(node, "", change));
      }
      for (String field : List.of("left", "right")) {
        OF_FIELDS.forEach(change -> faults.add(fault(node, field, change)));
      }
    }
    return faults;
  }

  private static OutputFault fault(String node, String field, Change change) {
    return new OutputFault(node, "/" + node, "t/msg/T", field, change, 1, "", new Range(0, 9));
  }

  private static List<OutputFault> ordered() {
    return SampleOrder.of(faults(), Function.identity());
  }

  @Test
  void omissionsComeFirst() {
    List<OutputFault> ordered = ordered();
    assertEquals(4, ordered.stream().limit(4).filter(OutputFault::isOmission).count());
    assertEquals(faults().size(), ordered.size());
    assertEquals(Set.copyOf(faults()), Set.copyOf(ordered));
  }

  @Test
  void theBeginningHasAllComponentsOutputsAndKinds() {
    List<OutputFault> first = ordered().subList(4, 10);
    Set<String> outputs = new TreeSet<>();
    first.forEach(each -> outputs.add(each.node() + "." + each.field()));
    assertEquals(
        Set.of("Gap.", "Gap.left", "Gap.right", "Speed.", "Speed.left", "Speed.right"), outputs);
    // Of what is left for whole messages, there is one kind only.
    assertEquals(5, first.stream().map(OutputFault::change).distinct().count());
  }

  @Test
  void faultsOfWholeMessagesAloneStayInTheirOrder() {
    List<OutputFault> delays =
        List.of(fault("Gap", "", Change.DELAYED), fault("Gap", "", Change.HELD));
    assertEquals(delays, SampleOrder.of(delays, Function.identity()));
  }

  /** Returns the first faults that requirements with a bound need, each of its component. */
  private static List<OutputFault> missing(Requirement... counted) {
    return SampleOrder.missing(
        ordered(), List.of(counted), (each, fault) -> each.components().contains(fault.node()));
  }

  /** Returns what counts for a bound: some tried faults of components, and some that are left. */
  private static Requirement counted(int tried, int left, String... components) {
    List<Reaction> reactions =
        Collections.nCopies(
            tried, new Reaction(components[0], "stuck", true, "far", "", Optional.empty(), false));
    return new Requirement(
        "BRK-1",
        List.of(components),
        List.of(List.of(components)),
        Set.of(),
        true,
        reactions,
        Collections.nCopies(left, new LeftOut(components[0], "/" + components[0], false)));
  }

  @Test
  void aBoundIsComparedWithSixFaults() {
    List<OutputFault> first = missing(counted(0, 13, "Speed"));
    assertEquals(Strength.ENOUGH, first.size());
    assertTrue(first.stream().allMatch(each -> each.node().equals("Speed")), first.toString());
    assertEquals(2, first.stream().filter(OutputFault::isOmission).count());
    assertEquals(first, ordered().stream().filter(first::contains).toList());
    assertEquals(first.subList(0, 2), missing(counted(4, 9, "Speed")));
    assertEquals(List.of(), missing(counted(6, 7, "Speed")));
  }

  @Test
  void aBoundIsComparedWithFewerFaultsIfThereAreNoMore() {
    assertEquals(1, missing(counted(2, 1, "Speed")).size());
    assertEquals(List.of(), missing(counted(2, 0, "Speed")));
  }

  @Test
  void boundsShareTheFaultsThatCountForThem() {
    Requirement speed = counted(0, 13, "Speed");
    assertEquals(missing(speed), missing(speed, counted(2, 9, "Speed")));
    assertEquals(8, missing(counted(2, 9, "Speed"), counted(2, 9, "Gap")).size());
    assertEquals(6, missing(speed, counted(3, 9, "Speed", "Gap")).size());
  }
}
