package dev.eventchain.pipeline.generate;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.m2t.generation.GenerationTrace;
import dev.eventchain.m2t.generation.GenerationTrace.Origin;
import dev.eventchain.m2t.generation.GenerationTrace.Segment;
import dev.eventchain.pipeline.results.ResultJson;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * The file that maps the lines of generated files to template lines and model elements, as JSON
 * with a line for each range of output lines:
 *
 * <pre>
 * {"files":[{"file":"ros2/aeb/aeb/x_node.py","lines":[
 *   {"first":1,"last":3,"from":[{"template":"templates/ros2-python/node.mtl","line":12,
 *     "element":"EventChain[aeb]/software[X]","model":"chain.xmi","modelLine":7}]}]}]}
 * </pre>
 *
 * <p>Unknown values are omitted: {@code element}, {@code model} and {@code modelLine} without a
 * model element, or if its location is unknown.
 */
public final class TraceFile {

  public static final String NAME = "trace.json";

  /** The content of the file. */
  record Content(List<Lined> files) {
    /** Copies the list. */
    Content {
      files = List.copyOf(files);
    }
  }

  /** A generated file with its ranges of lines. */
  record Lined(String file, List<Range> lines) {}

  /** A range of lines and its origins. */
  record Range(int first, int last, List<From> from) {}

  /** A template's line and the model element that it was evaluated for. */
  record From(
      String template,
      int line,
      Optional<String> element,
      Optional<String> model,
      OptionalLong modelLine) {}

  private final List<String> bases;

  private TraceFile(List<Path> bases) {
    this.bases = bases.stream().map(base -> SourceLocation.of(base).file() + "/").toList();
  }

  /**
   * Returns the file's content.
   *
   * @param prefix the prefix of the names of generated files
   * @param bases folders for relative names of templates and models, so that the content does not
   *     depend on the project's location; the first one that contains a file is used
   */
  public static byte[] content(GenerationTrace trace, String prefix, List<Path> bases) {
    TraceFile file = new TraceFile(bases);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (JsonGenerator json = new JsonFactory().createGenerator(bytes)) {
      json.writeStartObject();
      json.writeArrayFieldStart("files");
      for (Map.Entry<String, List<Segment>> each : trace.files().entrySet()) {
        json.writeStartObject();
        json.writeStringField("file", prefix + each.getKey());
        json.writeArrayFieldStart("lines");
        for (Segment segment : each.getValue()) {
          json.writeRaw("\n");
          file.write(segment, json);
        }
        json.writeEndArray();
        json.writeEndObject();
      }
      json.writeEndArray();
      json.writeEndObject();
      json.writeRaw("\n");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return bytes.toByteArray();
  }

  /**
   * Reads the content of the file.
   *
   * @throws IOException if it is not what {@link #content} returns
   */
  static Content read(byte[] file) throws IOException {
    return ResultJson.read(file, Content.class);
  }

  private void write(Segment segment, JsonGenerator json) throws IOException {
    json.writeStartObject();
    json.writeNumberField("first", segment.firstLine());
    json.writeNumberField("last", segment.lastLine());
    json.writeArrayFieldStart("from");
    for (Origin origin : segment.origins()) {
      write(origin, json);
    }
    json.writeEndArray();
    json.writeEndObject();
  }

  private void write(Origin origin, JsonGenerator json) throws IOException {
    SourceLocation element = origin.element();
    json.writeStartObject();
    json.writeStringField("template", relative(origin.template().file()));
    json.writeNumberField("line", origin.template().line());
    if (!element.element().isEmpty()) {
      json.writeStringField("element", element.element());
    }
    if (!element.file().isEmpty()) {
      json.writeStringField("model", relative(element.file()));
    }
    if (element.line() > 0) {
      json.writeNumberField("modelLine", element.line());
    }
    json.writeEndObject();
  }

  private String relative(String file) {
    return bases.stream()
        .filter(file::startsWith)
        .findFirst()
        .map(base -> file.substring(base.length()))
        .orElse(file);
  }
}
