package dev.eventchain.llm;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonPointer;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.llm.ChatResponse.FinishReason;
import dev.eventchain.llm.ChatResponse.Usage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/**
 * Reads a recording strictly: what the format does not say is a problem with its line and column,
 * and all are reported.
 */
final class RecordingReader {
  private static final JsonMapper MAPPER =
      JsonMapper.builder()
          .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
          .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
          .enable(DeserializationFeature.USE_BIG_DECIMAL_FOR_FLOATS)
          .build();
  private static final String TEXT_OR_LINES = "a text or an array of lines";

  private final SourceText source;
  private final List<Diagnostic> problems = new ArrayList<>();

  private RecordingReader(SourceText source) {
    this.source = source;
  }

  /**
   * Reads a file of format {@code llm-recording/1}.
   *
   * @throws DiagnosticException INPUT with every problem found
   */
  static Recording read(Path file) {
    return new RecordingReader(SourceText.read(file)).read();
  }

  private Recording read() {
    JsonNode root = parse();
    properties(root, JsonPointer.empty(), Set.of("format", "key", "request", "samples"));
    stopOnProblems();
    if (!root.get("format").asText().equals(RecordingWriter.FORMAT)) {
      report(
          "llm.recording.format", "/format", "The format is not " + RecordingWriter.FORMAT + ".");
    }
    request(root.get("request"));
    List<Recording.Sample> samples = samples(root.get("samples"));
    stopOnProblems();
    ObjectNode request = RequestJson.withTexts((ObjectNode) root.get("request"));
    RequestKey key = RequestKey.of(request);
    if (!root.get("key").asText().equals(key.value())) {
      report(
          "llm.recording.key",
          "/key",
          "The key does not belong to this request, whose key is " + key.value() + ".");
    }
    stopOnProblems();
    return new Recording(key, request, samples);
  }

  private JsonNode parse() {
    try {
      return MAPPER.readTree(source.text());
    } catch (JsonProcessingException e) {
      SourceLocation place =
          e.getLocation() == null
              ? source.at(0)
              : source.at(e.getLocation().getLineNr(), e.getLocation().getColumnNr());
      throw broken(
          List.of(Diagnostic.error("llm.recording.json", "This is no JSON: " + reason(e), place)));
    }
  }

  /** What the parser says, without its settings and a second place. */
  private static String reason(JsonProcessingException e) {
    return e.getOriginalMessage().replaceFirst("(?s)( \\(start marker|: enable `|\\R).*$", "");
  }

  private void request(JsonNode request) {
    properties(
        request,
        JsonPointer.compile("/request"),
        Set.of("provider", "model", "messages", "schema", "sampling"));
    check(request.path("provider"), "/request/provider", JsonNode::isTextual, "a string");
    check(request.path("model"), "/request/model", JsonNode::isTextual, "a string");
    check(request.path("sampling"), "/request/sampling", JsonNode::isObject, "an object");
    JsonNode messages = request.path("messages");
    check(messages, "/request/messages", JsonNode::isArray, "an array");
    for (int i = 0; i < messages.size(); i++) {
      String pointer = "/request/messages/" + i;
      properties(messages.get(i), JsonPointer.compile(pointer), Set.of("role", "content"));
      check(messages.get(i).path("role"), pointer + "/role", JsonNode::isTextual, "a string");
      check(
          messages.get(i).path("content"),
          pointer + "/content",
          RecordingReader::isText,
          TEXT_OR_LINES);
    }
  }

  private List<Recording.Sample> samples(JsonNode samples) {
    check(samples, "/samples", JsonNode::isArray, "an array");
    List<Recording.Sample> result = new ArrayList<>();
    for (int i = 0; i < samples.size(); i++) {
      sample(samples.get(i), "/samples/" + i).ifPresent(result::add);
    }
    if (samples.isArray() && samples.isEmpty()) {
      report("llm.recording.format", "/samples", "A recording holds at least one sample.");
    }
    return result;
  }

  private Optional<Recording.Sample> sample(JsonNode json, String pointer) {
    int before = problems.size();
    Set<String> names =
        Set.of("recordedAt", "provenance", "model", "finishReason", "usage", "text");
    properties(json, JsonPointer.compile(pointer), names);
    for (String name : List.of("recordedAt", "provenance", "model")) {
      check(json.path(name), pointer + "/" + name, JsonNode::isTextual, "a string");
    }
    check(json.path("text"), pointer + "/text", RecordingReader::isText, TEXT_OR_LINES);
    check(
        json.path("finishReason"),
        pointer + "/finishReason",
        reason -> finishReason(reason).isPresent(),
        "one of stop, length, refusal, other");
    check(json.path("usage"), pointer + "/usage", RecordingReader::isUsage, "null or token counts");
    if (problems.size() > before) {
      return Optional.empty();
    }
    JsonNode usage = json.get("usage");
    ChatResponse response =
        new ChatResponse(
            RequestJson.text(json.get("text")),
            finishReason(json.get("finishReason")).orElseThrow(),
            json.get("model").asText(),
            json.get("provenance").asText(),
            usage.isNull()
                ? Optional.empty()
                : Optional.of(
                    new Usage(usage.get("input").asLong(), usage.get("output").asLong())));
    return Optional.of(new Recording.Sample(json.get("recordedAt").asText(), response));
  }

  private static boolean isText(JsonNode node) {
    if (node.isArray()) {
      for (JsonNode line : node) {
        if (!line.isTextual() || line.asText().contains("\n")) {
          return false;
        }
      }
      return !node.isEmpty();
    }
    return node.isTextual();
  }

  private static boolean isUsage(JsonNode node) {
    return node.isNull()
        || (node.size() == 2
            && node.path("input").isIntegralNumber()
            && node.path("output").isIntegralNumber());
  }

  private static Optional<FinishReason> finishReason(JsonNode node) {
    return Arrays.stream(FinishReason.values())
        .filter(reason -> reason.name().toLowerCase(Locale.ROOT).equals(node.asText()))
        .findFirst();
  }

  private void properties(JsonNode node, JsonPointer pointer, Set<String> expected) {
    if (!node.isObject()) {
      report("llm.recording.format", pointer.toString(), "An object is expected here.");
      return;
    }
    expected.stream()
        .sorted()
        .filter(name -> !node.has(name))
        .forEach(
            name ->
                report("llm.recording.format", pointer.toString(), "'" + name + "' is missing."));
    node.fieldNames()
        .forEachRemaining(
            name -> {
              if (!expected.contains(name)) {
                report(
                    "llm.recording.format",
                    pointer.appendProperty(name).toString(),
                    "'" + name + "' does not belong here.");
              }
            });
  }

  private void check(
      JsonNode node, String pointer, Predicate<JsonNode> condition, String expectation) {
    if (!node.isMissingNode() && !condition.test(node)) {
      report("llm.recording.format", pointer, "Expected here: " + expectation + ".");
    }
  }

  private void report(String id, String pointer, String message) {
    problems.add(Diagnostic.error(id, message, locate(JsonPointer.compile(pointer))));
  }

  private SourceLocation locate(JsonPointer wanted) {
    try (JsonParser parser = MAPPER.createParser(source.text())) {
      for (JsonToken token = parser.nextToken(); token != null; token = parser.nextToken()) {
        if (token != JsonToken.FIELD_NAME
            && parser.getParsingContext().pathAsPointer().equals(wanted)) {
          var place = parser.currentTokenLocation();
          return source.at(place.getLineNr(), place.getColumnNr()).withElement(wanted.toString());
        }
      }
      return source.at(0).withElement(wanted.toString());
    } catch (IOException e) {
      throw new IllegalStateException("the same text was parsed before", e);
    }
  }

  private void stopOnProblems() {
    if (!problems.isEmpty()) {
      throw broken(problems);
    }
  }

  private static DiagnosticException broken(List<Diagnostic> problems) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT, problems.stream().map(RecordingReader::hinted).toList());
  }

  private static Diagnostic hinted(Diagnostic problem) {
    return problem.withHint("Restore the recording, or delete it and record it again.");
  }
}
