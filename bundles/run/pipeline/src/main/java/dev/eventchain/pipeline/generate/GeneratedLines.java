package dev.eventchain.pipeline.generate;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.MissingNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.stage.RunContext;
import java.io.IOException;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;

/** Which lines of the generated files were made for which component, as trace.json says. */
public final class GeneratedLines {

  private final JsonNode files;

  private GeneratedLines(JsonNode files) {
    this.files = files;
  }

  /** Nothing where the output has no trace, or where it is unreadable. */
  public static GeneratedLines of(RunContext run) {
    Optional<byte[]> trace = run.output().read(TraceFile.NAME);
    try {
      JsonNode root =
          trace.isPresent() ? new ObjectMapper().readTree(trace.get()) : MissingNode.getInstance();
      return new GeneratedLines(root.path("files"));
    } catch (IOException e) {
      return new GeneratedLines(MissingNode.getInstance());
    }
  }

  /**
   * The files with lines that a component or its data made: {@code node}, {@code file} and {@code
   * lines}, each {@code first}, {@code last} and the template's line in {@code from}.
   *
   * @param locator where elements are, as the generation was told
   */
  public ArrayNode madeFor(SoftwareNode node, Function<EObject, SourceLocation> locator) {
    Set<String> elements = new TreeSet<>();
    Stream.of(Stream.of(node), node.getInput().stream(), node.getOutput().stream())
        .flatMap(each -> each)
        .map(locator)
        .forEach(place -> elements.add(key(place.element(), place.line())));
    ArrayNode made = JsonNodeFactory.instance.arrayNode();
    for (JsonNode file : files) {
      ArrayNode lines = linesOf(file, elements);
      if (!lines.isEmpty()) {
        ObjectNode entry = made.addObject();
        entry.put("node", node.getName()).put("file", file.path("file").asText());
        entry.set("lines", lines);
      }
    }
    return made;
  }

  private static ArrayNode linesOf(JsonNode file, Set<String> elements) {
    ArrayNode lines = JsonNodeFactory.instance.arrayNode();
    for (JsonNode segment : file.path("lines")) {
      for (JsonNode origin : segment.path("from")) {
        String element = key(origin.path("element").asText(), origin.path("modelLine").asInt());
        if (elements.contains(element)) {
          lines
              .addObject()
              .put("first", segment.path("first").asInt())
              .put("last", segment.path("last").asInt())
              .put("from", origin.path("template").asText() + ":" + origin.path("line").asInt());
          break;
        }
      }
    }
    return lines;
  }

  /**
   * Elements may have the same name. Those that also stand on the same line, as in a model written
   * on one line by hand, cannot be told apart and share their lines.
   */
  private static String key(String element, int line) {
    return line + " " + element;
  }
}
