package dev.eventchain.contracts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.ModelChange;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Changes of a model that findings propose, and which of them need no question. */
class ProposedChangesTest {

  private static final Path CASES = Path.of("src/test/resources/cases");

  @TempDir Path folder;

  private static List<ModelChange> changes(Path of, String rule) {
    List<Diagnostic> found = RuleCasesTest.analyse(of).diagnostics();
    assertTrue(found.stream().anyMatch(each -> each.id().equals(rule)), found::toString);
    return found.stream()
        .filter(each -> each.id().equals(rule))
        .flatMap(each -> each.changes().stream())
        .toList();
  }

  /** Returns the changes for two units: of the reader, and of the writer. */
  private List<ModelChange> changes(String here, String there) throws IOException {
    Path from = CASES.resolve("contract.unit.mismatch/bad-unknown-text");
    String chain = Files.readString(from.resolve("chain.xmi"));
    String written =
        chain
            .replaceAll("(fieldName=\"speed\"[^>]* unit=\")m/s\"", "$1" + there + "\"")
            .replace("\"knots\"", "\"" + here + "\"");
    Files.writeString(folder.resolve("chain.xmi"), written);
    Files.copy(from.resolve("signals.json"), folder.resolve("signals.json"));
    Path messages = Path.of("msg/limiter_msgs/msg/Filtered.msg");
    Files.createDirectories(folder.resolve(messages).getParent());
    Files.copy(from.resolve(messages), folder.resolve(messages));
    return changes(folder, "contract.unit.mismatch");
  }

  @ParameterizedTest
  @CsvSource({"kmph, km/h", "kmperh, km/h", "km per h, km/h", "mmps, mm/s", "radps, rad/s"})
  void aUnitThatIsOnlySpeltDifferentlyIsChangedWithoutAQuestion(String here, String there)
      throws IOException {
    List<ModelChange> changes = changes(here, there);
    assertEquals(
        List.of("Change the unit to '" + there + "'"),
        changes.stream().map(ModelChange::title).toList());
    assertTrue(changes.get(0).certain());
    assertEquals(List.of(here, there), List.of(changes.get(0).from(), changes.get(0).to()));
  }

  /** Each is another unit, or may be one, even if one letter makes the difference. */
  @ParameterizedTest
  @CsvSource({"kmph, m/s", "km/hr, m/s", "knots, m/s", "f/s, m/s", "yd, d", "mw, mW", "km/h, m/s"})
  void aUnitThatMayBeAnotherOneIsChangedOnRequest(String here, String there) throws IOException {
    List<ModelChange> changes = changes(here, there);
    assertEquals(
        List.of("Change the unit to '" + there + "', which the component's code must follow"),
        changes.stream().map(ModelChange::title).toList());
    assertEquals(List.of(false), changes.stream().map(ModelChange::certain).toList());
  }

  @ParameterizedTest
  @CsvSource({"kmph, kmp/h", "km/h, kmph", "kg, m/s", "rad/s, 1/s"})
  void noUnknownUnitAndNoOtherQuantityIsProposed(String here, String there) throws IOException {
    assertEquals(List.of(), changes(here, there));
  }

  @ParameterizedTest
  @ValueSource(strings = {"bad-from-vehicle", "bad-to-vehicle"})
  void onlyTheSideThatIsNotTheVehicleCanChange(String name) {
    List<ModelChange> changes =
        changes(
            CASES.resolve("contract.qos.incompatible").resolve(name), "contract.qos.incompatible");
    assertEquals(List.of(true), changes.stream().map(ModelChange::certain).toList());
  }

  /** Of deadlines and leases, which are times, people choose one. */
  @Test
  void eachPolicyIsChangedOnEitherSide() {
    Path folder = CASES.resolve("contract.qos.incompatible/bad-every-policy");
    List<ModelChange> changes = changes(folder, "contract.qos.incompatible");
    assertEquals(
        List.of(
            "Request durability VOLATILE in 'Brake_Decision'",
            "Offer durability TRANSIENT_LOCAL in 'Speed_Filter'",
            "Request liveliness AUTOMATIC in 'Brake_Decision'",
            "Offer liveliness MANUAL_BY_TOPIC in 'Speed_Filter'",
            "Request reliability BEST_EFFORT in 'Brake_Decision'",
            "Offer reliability RELIABLE in 'Speed_Filter'"),
        changes.stream().map(ModelChange::title).toList());
    assertTrue(changes.stream().noneMatch(ModelChange::certain));
    for (ModelChange change : changes) {
      assertEquals("qos", change.child());
      assertTrue(
          change.title().contains(" %s %s in ".formatted(change.attribute(), change.to())),
          change::toString);
      assertEquals(change.title().startsWith("Request") ? 12 : 8, change.place().line());
    }
  }
}
