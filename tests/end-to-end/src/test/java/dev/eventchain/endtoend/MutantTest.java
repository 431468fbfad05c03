package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that mutants are read only with a failing criterion or a reason for equivalence. */
class MutantTest {

  @TempDir Path folder;

  private Path file(String entries, String ofTheChange) throws IOException {
    String text =
        """
        mutants:
        - {id: one, does: wrong, component: First, scenario: only%s,
           change: [{replace: old, by: new%s}]}
        """;
    return Files.writeString(folder.resolve("mutants.yaml"), text.formatted(entries, ofTheChange));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        ", criterion: ''",
        ", criterion: ' '",
        ", equivalent: ''",
        ", criterion: stops, equivalent: nobody sees it",
        ", criterion: stops, reason: unknown",
        ", criterion: 3",
      })
  void refusesWhatDoesNotSayWhatFailsIt(String entries) throws IOException {
    Path file = file(entries, "");
    assertThrows(IllegalArgumentException.class, () -> Mutant.read(file));
  }

  @Test
  void refusesChangeWithAnUnknownKey() throws IOException {
    Path file = file(", criterion: stops", ", file: Second");
    assertThrows(IllegalArgumentException.class, () -> Mutant.read(file));
  }

  @Test
  void changesAnotherComponentWhereTheChangeNamesIt() throws IOException {
    Path first = Files.writeString(folder.resolve("First.py"), "old");
    Path second = Files.writeString(folder.resolve("Second.py"), "very old");
    Mutant.read(file(", equivalent: nobody sees it", "")).get(0).putInto(folder);
    Mutant.read(file(", criterion: stops", ", component: Second")).get(0).putInto(folder);
    assertEquals("new", Files.readString(first));
    assertEquals("very new", Files.readString(second));
  }
}
