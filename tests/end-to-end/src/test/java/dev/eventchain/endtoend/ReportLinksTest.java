package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.fixtures.InTurn;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the links of the report from each requirement to components and their generated lines. */
class ReportLinksTest {

  @TempDir Path folder;

  @InTurn
  @Test
  void linesOfARequirementAreThoseOfItsComponents() throws IOException {
    Path project = Program.exampleIn(folder);
    Path out = project.resolve("out");
    new Program().run("run", project).expect(0);

    Map<String, String> linesByNode = new TreeMap<>();
    for (JsonNode requirement : data(out).path("requirements")) {
      for (JsonNode made : requirement.path("generated")) {
        List<String> lines = Files.readAllLines(out.resolve(made.path("file").asText()));
        for (JsonNode part : made.path("lines")) {
          int first = part.path("first").asInt();
          int last = part.path("last").asInt();
          assertTrue(0 < first && first <= last && last <= lines.size(), made.toString());
          assertTrue(isLineOfATemplate(part.path("from").asText()), part.toString());
          linesByNode.merge(
              made.path("node").asText(),
              String.join("\n", lines.subList(first - 1, last)) + "\n",
              String::concat);
        }
      }
    }

    List<String> nodes =
        List.of("Braking_Decision", "Carla_Vehicle_Control", "ObjectDetection", "TTC_Calculation");
    assertEquals(nodes, new ArrayList<>(linesByNode.keySet()));
    linesByNode.forEach(
        (node, lines) -> {
          assertTrue(lines.contains(node), () -> node + " is not in\n" + lines);
          nodes.stream()
              .filter(other -> !other.equals(node))
              .forEach(other -> assertTrue(!lines.contains(other + "_node("), () -> other + lines));
        });
    assertTrue(linesByNode.get("TTC_Calculation").contains("\"/scan\""));
  }

  private static JsonNode data(Path out) throws IOException {
    String page = Files.readString(out.resolve("report.html"));
    String start = "<script type=\"application/json\" id=\"data\">";
    int from = page.indexOf(start) + start.length();
    return new ObjectMapper().readTree(page.substring(from, page.indexOf("</script>", from)));
  }

  private static boolean isLineOfATemplate(String place) throws IOException {
    int colon = place.lastIndexOf(':');
    int line = Integer.parseInt(place.substring(colon + 1));
    Path file = Program.ROOT.resolve(place.substring(0, colon));
    return line > 0 && line <= Files.readAllLines(file).size();
  }
}
