package dev.eventchain.agents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import dev.eventchain.diagnostics.SourceText;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class NotAskedTest {

  private static final String CHAIN =
      SourceText.read(Path.of("src/test/resources/implement/chain.json")).text();

  /** A design and a model are about messages, in whose units the components come together. */
  @Test
  void chainsAreShownWithTheUnitsOfMessages() {
    String converted =
        CHAIN.replace("\"unit\": \"m/s\"", "\"unit\": \"m/s\", \"component_unit\": \"km/h\"");
    assertNotEquals(CHAIN, converted);
    assertEquals(
        NotAsked.without(SourceText.of("chain.json", CHAIN)),
        NotAsked.without(SourceText.of("chain.json", converted)));
  }
}
