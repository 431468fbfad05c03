package dev.eventchain.llm.recording;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.documents.AtomicFile;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.RequestJson;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;

/**
 * Writes recordings in the format {@code llm-recording/1}, laid out for review: texts are arrays of
 * lines.
 */
final class RecordingWriter {
  static final String FORMAT = "llm-recording/1";

  private RecordingWriter() {}

  static void write(Path file, Recording recording) throws IOException {
    AtomicFile.write(file, toJson(recording));
  }

  private static String toJson(Recording recording) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("format", FORMAT);
    json.put("key", recording.key().value());
    json.set("request", RequestJson.withLines(recording.request()));
    ArrayNode samples = json.putArray("samples");
    recording.samples().forEach(sample -> append(samples.addObject(), sample));
    return JsonLayout.of(json) + "\n";
  }

  private static void append(ObjectNode json, Recording.Sample sample) {
    ChatResponse response = sample.response();
    json.put("recordedAt", sample.recordedAt());
    json.put("provenance", response.provenance());
    json.put("model", response.model());
    json.put("finishReason", response.finishReason().name().toLowerCase(Locale.ROOT));
    response
        .usage()
        .ifPresentOrElse(
            usage ->
                json.putObject("usage")
                    .put("input", usage.inputTokens())
                    .put("output", usage.outputTokens()),
            () -> json.putNull("usage"));
    json.set("text", RequestJson.lines(response.text()));
  }
}
