package dev.eventchain.simulation.strength;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.simulation.fault.OutputFault;
import dev.eventchain.simulation.fault.OutputFault.Change;
import dev.eventchain.simulation.fault.OutputFault.Range;
import java.util.ArrayList;
import java.util.List;
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
}
