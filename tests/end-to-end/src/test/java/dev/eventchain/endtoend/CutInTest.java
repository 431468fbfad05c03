package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.InTurn;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Thorough;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the drivers of the example against the published outcome of their cut-ins. */
class CutInTest {

  private static final String CELLS = "campaigns/r157-cells.csv";

  /**
   * Number of cells that a build simulates, other ones each day; the profile {@code thorough}: all.
   */
  private static final int CELLS_OF_A_BUILD = 28;

  /** Numbers in the README of the example. */
  private static final int DIFFERENT = 32;

  private static final Map<String, String> NUMBERS =
      Map.of("CC_human_driver", "1", "Reg157", "2", "RSS", "3", "FSM", "4");

  @TempDir private Path folder;

  private static List<String> table() throws IOException {
    return Files.readAllLines(Program.ROOT.resolve("examples/cut-in").resolve(CELLS));
  }

  private static boolean label(String row) {
    return row.split(",", -1)[5].equals("1");
  }

  /** Rounding decides cells in which a body is exactly at the edge of another one in a sample. */
  @Test
  void whatIsWrittenFromTheDescriptionHasTheLabels() throws IOException {
    List<String> rows = table();
    int different = 0;
    for (String row : rows.subList(1, rows.size())) {
      CutInReference cell = CutInReference.of(row.split(",", -1));
      if (cell.hits() != label(row)) {
        different++;
        assertTrue(row.endsWith(",1"), row);
        assertTrue(cell.isBesideTheBoundary(), row);
      }
    }
    assertTrue(different < 20, different + " of " + (rows.size() - 1));
  }

  @Test
  void theCampaignHasTheLabelsExceptBesideTheBoundary() throws IOException {
    ProjectCopy copy = ProjectCopy.of("cut-in", folder);
    Map<String, String> cells = new HashMap<>();
    List<String> rows = ofThisBuild(table());
    rows.subList(1, rows.size()).forEach(row -> cells.put(key(row.split(",", -1), 0), row));
    copy.write(CELLS, String.join("\n", rows) + "\n");
    new Program()
        .run("campaign", copy.path(), copy.path().resolve("campaigns/r157.yaml"))
        .expect(1)
        .says(cells.size() + " cases: ")
        .says(" 0 not tested, 0 ended by an error");
    List<String> different = new ArrayList<>();
    List<String> cases = Files.readAllLines(copy.path().resolve("out/campaigns/r157/cases.csv"));
    for (String each : cases.subList(1, cases.size())) {
      String row = cells.remove(key(each.split(",", -1), 1));
      if (each.contains(",failed,") != label(row)) {
        different.add(row);
      }
    }
    assertEquals(Map.of(), cells);
    for (String row : different) {
      assertTrue(CutInReference.of(row.split(",", -1)).isBesideTheBoundary(), row);
    }
    if (Thorough.IS_ON) {
      assertEquals(DIFFERENT, different.size(), different::toString);
    }
  }

  private static List<String> ofThisBuild(List<String> table) {
    int every = Thorough.IS_ON ? 1 : (table.size() - 1) / CELLS_OF_A_BUILD;
    List<String> rows = new ArrayList<>(List.of(table.get(0)));
    for (int i = 1; i < table.size(); i++) {
      if (Math.floorMod(i + Thorough.turn(), every) == 0) {
        rows.add(table.get(i));
      }
    }
    return rows;
  }

  /** Returns the factors of a row, from a column on, with the number of the model. */
  private static String key(String[] row, int first) {
    StringBuilder key = new StringBuilder(NUMBERS.getOrDefault(row[first], row[first]));
    for (int i = first + 1; i < first + 5; i++) {
      key.append(' ').append(new BigDecimal(row[i]).doubleValue());
    }
    return key.toString();
  }

  @InTurn
  @Test
  void everyRequirementIsProved() throws IOException {
    ProjectCopy copy = ProjectCopy.of("cut-in", folder);
    Projects.withoutStrength(copy.path());
    copy.run().expect(0).says("PASSED: 10 of 10 scenarios passed, 11 requirements proved");
    Program.requireBoundsHold(copy.path());
  }
}
