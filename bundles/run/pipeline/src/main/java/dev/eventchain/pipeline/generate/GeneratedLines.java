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

/** Lines of the generated files by the component that they were generated for, from trace.json. */
public final class GeneratedLines {

  private final JsonNode files;

  private GeneratedLines(JsonNode files) {
    this.files = files;
  }

  /** Reads the trace; empty if it is missing or unreadable. */
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
   * Returns the files with lines generated for a component or its data: {@code node}, {@code file}
   * and {@code lines}, each {@code first}, {@code last} and the template's line in {@code from}.
   *
   * @param locator returns the locations of elements, as in the generation
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
   * Returns the key of an element by name and line. Elements with the same name on the same line,
   * as in handwritten one-line models, share their lines.
   */
  private static String key(String element, int line) {
    return line + " " + element;
  }
}
