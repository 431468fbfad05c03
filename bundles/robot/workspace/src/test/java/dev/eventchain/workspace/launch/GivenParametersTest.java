package dev.eventchain.workspace.launch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.node.IntNode;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests which nodes a name with wildcards means; that of other readers is asked for. */
class GivenParametersTest {

  @ParameterizedTest
  @CsvSource({
    "/left/filter, true",
    "left/filter, true",
    "/*/filter, true",
    "/left/*, true",
    "/**/filter, true",
    "/left/**, true",
    "/**/left/**/filter, true",
    "/*, false",
    "/*/*/filter, false",
    "/left, false",
    "/left/filter/**, true",
    "/left/filters, false",
    "/left/fil*, false"
  })
  void wildcardsStandForPartsOfNames(String nodes, boolean matches) {
    assertEquals(matches ? Set.of("limit") : Set.of(), given(nodes, "/left/filter"));
  }

  /**
   * A file that is not known may have a section for the node, which all nodes' does not replace.
   */
  @ParameterizedTest
  @CsvSource({"/node, false, true", "/node, true, false", "/**, false, true", "/**, true, true"})
  void anUnknownFileMayReplaceWhatTheNodeIsNotGivenByNameBehindIt(
      String nodes, boolean isLast, boolean isUnknown) {
    List<ParameterAssignment> all = new ArrayList<>();
    all.add(new ParameterAssignment("/**", "rate", Optional.of(IntNode.valueOf(1))));
    all.add(new ParameterAssignment(nodes, "limit", Optional.of(IntNode.valueOf(1))));
    all.add(isLast ? 0 : all.size(), ParameterAssignment.unknown());
    GivenParameters found = GivenParameters.of(all, Optional.of("/node"), new ArrayList<>()::add);
    assertEquals(Set.of("rate", "limit"), found.values().keySet());
    assertEquals(isUnknown, found.unknown().contains("limit"));
    assertTrue(found.isOpen());
  }

  /** A file that is not known says nothing of the order of names, which other files decide. */
  @Test
  void versionsDifferBehindAnUnknownFile() {
    List<String> asked = new ArrayList<>();
    GivenParameters found =
        GivenParameters.of(
            List.of(
                ParameterAssignment.unknown(),
                new ParameterAssignment("/node", "limit", Optional.of(IntNode.valueOf(1))),
                new ParameterAssignment("/**", "limit", Optional.of(IntNode.valueOf(2)))),
            Optional.of("/node"),
            asked::add);
    assertEquals(Set.of("limit"), found.unknown());
    assertTrue(asked.get(0).startsWith("What is the parameter 'limit' of this node: 1 or 2?"));
  }

  @Test
  void manyWildcardsTakeNoLongTime() {
    String nodes = "/**/a".repeat(40) + "/b";
    assertTimeoutPreemptively(
        Duration.ofSeconds(20), () -> assertEquals(Set.of(), given(nodes, "/a".repeat(80))));
  }

  /** Returns the parameters that a node may have from those of some nodes. */
  private static Set<String> given(String nodes, String node) {
    GivenParameters found =
        GivenParameters.of(
            List.of(new ParameterAssignment(nodes, "limit", Optional.of(IntNode.valueOf(1)))),
            Optional.of(node),
            new ArrayList<>()::add);
    return found.values().isEmpty() ? found.unknown() : found.values().keySet();
  }
}
