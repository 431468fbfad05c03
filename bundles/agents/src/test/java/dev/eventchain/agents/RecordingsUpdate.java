package dev.eventchain.agents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.llm.ChatModels;
import dev.eventchain.llm.chat.ChatModel;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * Gives changed prompts the answers of the recordings that they replace. It answers by hand-off, as
 * a person would, with the recorded answer of the nearest prompt of the task.
 */
final class RecordingsUpdate {
  private static final JsonMapper MAPPER = new JsonMapper();

  private RecordingsUpdate() {}

  static void run(Path recordings, Path folder, Consumer<ChatModel> workflow) throws IOException {
    Path fresh = folder.resolve("recordings");
    Path handoff = folder.resolve("handoff");
    while (!isDone(handoff, fresh, workflow)) {
      try (Stream<Path> files = Files.list(handoff)) {
        for (Path prompt : files.filter(RecordingsUpdate::isOpen).toList()) {
          String task = prompt.getFileName().toString().replaceFirst("-\\d+\\.prompt\\.md$", "");
          String answer = nearestAnswer(recordings.resolve(task), Files.readString(prompt));
          Files.writeString(answerOf(prompt), "<!-- provenance: authored -->\n" + answer);
        }
      }
    }
    replace(recordings, fresh);
  }

  private static boolean isDone(Path handoff, Path fresh, Consumer<ChatModel> workflow) {
    try {
      workflow.accept(ChatModels.open("handoff:" + handoff, ExampleWorkflow.MODEL, fresh, true));
      return true;
    } catch (DiagnosticException e) {
      if (e.reason() != Reason.WAITING) {
        throw e;
      }
      return false;
    }
  }

  private static boolean isOpen(Path file) {
    return file.toString().endsWith(".prompt.md") && !Files.exists(answerOf(file));
  }

  private static Path answerOf(Path prompt) {
    return prompt.resolveSibling(
        prompt.getFileName().toString().replace(".prompt.md", ".answer.md"));
  }

  private static String nearestAnswer(Path task, String prompt) throws IOException {
    Set<String> wanted = words(prompt);
    String answer = "";
    long best = Long.MAX_VALUE;
    for (Path file : files(task)) {
      JsonNode recording = MAPPER.readTree(file.toFile());
      Set<String> there = new TreeSet<>();
      for (JsonNode message : recording.at("/request/messages")) {
        there.addAll(words(String.join("\n", lines(message.get("content")))));
      }
      long common = there.stream().filter(wanted::contains).count();
      long distance = there.size() + wanted.size() - 2 * common;
      if (distance < best) {
        best = distance;
        answer = String.join("\n", lines(recording.at("/samples/0/text")));
      }
    }
    return answer;
  }

  /** Returns the words of a prompt, which stay when its layout changes. */
  private static Set<String> words(String text) {
    return new TreeSet<>(List.of(text.split("\\W+")));
  }

  private static List<String> lines(JsonNode text) {
    List<String> lines = new ArrayList<>();
    text.forEach(line -> lines.add(line.asText()));
    return lines;
  }

  /** Keeps unchanged files, so that only changes appear in version control. */
  private static void replace(Path recordings, Path fresh) throws IOException {
    for (Path old : files(recordings)) {
      if (!Files.exists(fresh.resolve(recordings.relativize(old)))) {
        Files.delete(old);
      }
    }
    for (Path file : files(fresh)) {
      Path target = recordings.resolve(fresh.relativize(file));
      if (!Files.exists(target)) {
        Files.createDirectories(target.getParent());
        Files.copy(file, target);
      }
    }
  }

  private static List<Path> files(Path folder) throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      return files.filter(Files::isRegularFile).sorted().toList();
    }
  }
}
