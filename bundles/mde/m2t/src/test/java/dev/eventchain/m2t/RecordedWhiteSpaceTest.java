package dev.eventchain.m2t;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** White space in bodies of files and templates is the same as in Acceleo. */
class RecordedWhiteSpaceTest {
  private static final Path RECORDED = Path.of("src/test/resources/acceleo/white-space.tsv");
  private static final int SHOWN = 20;

  /** A body of a file (F) or a template (T), and the expected output. */
  private record Body(String kind, String text, String expected) {
    String written() {
      return kind.equals("F") ? WhiteSpaceBodies.file(text) : WhiteSpaceBodies.called(text);
    }
  }

  @Test
  void comesOutAsInAcceleo() throws IOException {
    List<Body> bodies = recorded();
    List<String> wrong = new ArrayList<>();
    for (Body body : bodies) {
      String written = body.written();
      if (!written.equals(body.expected())) {
        wrong.add(body + " but here: " + written);
      }
    }
    assertEquals(1584, bodies.size());
    List<String> first = wrong.stream().limit(SHOWN).toList();
    assertEquals(0, wrong.size(), () -> String.join("\n", first));
  }

  private static List<Body> recorded() throws IOException {
    ObjectMapper json = new ObjectMapper();
    List<Body> bodies = new ArrayList<>();
    for (String line : Files.readAllLines(RECORDED)) {
      if (!line.startsWith("#")) {
        String[] columns = line.split("\t", -1);
        String text = json.readValue(columns[1], String.class);
        bodies.add(new Body(columns[0], text, json.readValue(columns[2], String.class)));
      }
    }
    return bodies;
  }
}
