package dev.eventchain.mcp.tools;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.type.TypeReference;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.mcp.program.Ended;
import dev.eventchain.mcp.program.Program;
import dev.eventchain.mcp.program.RunningCall;
import dev.eventchain.mcp.project.Boundary;
import dev.eventchain.mcp.project.McpRules;
import dev.eventchain.mcp.tools.Tool.Call;
import dev.eventchain.mcp.tools.Tool.Result;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Commands as tools: what a command says is the text, and its JSON report is the structure. */
final class Commands {

  /** Schema of the answer of a command that reports findings. */
  static final Map<String, Object> OUTPUT = output();

  private static final int HEAD = 20_000;
  private static final int TAIL = 6_000;
  private static final int MOST_ENTRIES = 200;
  private static final Pattern VERDICT =
      Pattern.compile("^(PASSED|FAILED|INCOMPLETE): ", Pattern.MULTILINE);

  /** The commands that come to a verdict. */
  private static final Set<String> JUDGING = Set.of("run", "simulate");

  private static final ObjectMapper JSON = new ObjectMapper();

  private final Program program;
  private final Boundary boundary;

  Commands(Program program, Boundary boundary) {
    this.program = program;
    this.boundary = boundary;
  }

  private static Map<String, Object> output() {
    Map<String, Object> properties = new LinkedHashMap<>(plainOutput());
    properties.put("verdict", Map.of("enum", List.of("PASSED", "FAILED", "INCOMPLETE")));
    properties.put(
        "report", Map.of("type", "object", "description", "As --format json writes it."));
    properties.put(
        "leftOut",
        Map.of(
            "type", "integer", "description", "Entries of the report's lists that were left out."));
    return properties;
  }

  /** Schema of the answer of a command without findings. */
  static Map<String, Object> plainOutput() {
    Map<String, Object> properties = new LinkedHashMap<>();
    properties.put(
        "exitCode", Map.of("type", "integer", "description", "The command's exit code."));
    properties.put("meaning", Map.of("type", "string", "description", "What the exit code means."));
    return properties;
  }

  /** Runs a command that only prints. */
  Result print(List<String> arguments, Call call) {
    Ended ended = program.run(arguments, boundary.root(), call.running(), call.progress());
    return new Result(textOf(ended), ending(ended), !ended.worked());
  }

  /** Runs a command that prints a list, whose JSON is the structure. */
  Result list(List<String> arguments, Call call) {
    List<String> command = new ArrayList<>(arguments);
    command.add("--format=json");
    Ended ended = program.run(command, boundary.root(), call.running(), call.progress());
    Map<String, Object> structured = ending(ended);
    if (ended.worked()) {
      try {
        structured.putAll(JSON.readValue(ended.out(), new TypeReference<Map<String, Object>>() {}));
      } catch (JsonProcessingException e) {
        throw new UncheckedIOException(e);
      }
    }
    return new Result(textOf(ended), structured, !ended.worked());
  }

  /** Returns what a command prints, without progress. */
  Ended output(List<String> arguments, RunningCall call) {
    return program.run(arguments, boundary.root(), call, message -> {});
  }

  /** Runs a command that ends with a report, in the server's folder. */
  Result report(List<String> arguments, Call call) {
    return report(arguments, boundary.root(), call);
  }

  /** As above, in a folder that is a copy of the server's. */
  Result report(List<String> arguments, Path folder, Call call) {
    try {
      Path reports = Files.createTempDirectory("eventchain-report");
      Path file = reports.resolve("report.json");
      try {
        List<String> command = new ArrayList<>(arguments);
        command.add("--report=json=" + file);
        Ended ended = program.run(command, folder, call.running(), call.progress());
        Map<String, Object> structured = ending(ended);
        if (JUDGING.contains(arguments.get(0))) {
          verdict(ended).ifPresent(verdict -> structured.put("verdict", verdict));
        }
        addReport(structured, ended, file, folder);
        return new Result(textOf(ended), structured, !ended.worked());
      } finally {
        Files.deleteIfExists(file);
        Files.deleteIfExists(reports);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the verdict that a command has printed, if its exit code says the same. */
  private static Optional<String> verdict(Ended ended) {
    String last = null;
    for (Matcher line = VERDICT.matcher(ended.out()); line.find(); ) {
      last = line.group(1);
    }
    return Optional.ofNullable(last).filter(it -> it.equals("PASSED") == (ended.code() == 0));
  }

  private static void addReport(Map<String, Object> structured, Ended ended, Path file, Path folder)
      throws IOException {
    if (Files.exists(file)) {
      ObjectNode report = (ObjectNode) JSON.readTree(file.toFile());
      requireInside(report, folder);
      structured.put("leftOut", shorten(report));
      structured.put(
          "report", JSON.convertValue(report, new TypeReference<Map<String, Object>>() {}));
    } else if (ended.worked()) {
      throw new IllegalStateException("the command wrote no report: " + ended.err());
    }
  }

  private static Map<String, Object> ending(Ended ended) {
    Map<String, Object> structured = new LinkedHashMap<>();
    structured.put("exitCode", ended.code());
    structured.put(
        "meaning",
        switch (ended.code()) {
          case 0 -> "success";
          case 1 -> "findings of severity error, or a failed verdict";
          case 2 -> "wrong usage or unreadable input";
          case 3 -> "something this machine lacks, or a defect in eventchain";
          case 4 -> "waiting for an answer of a language model";
          default -> "ended by a signal";
        });
    return structured;
  }

  /** Removes entries of the report's lists that are too many for a message; returns how many. */
  private static int shorten(ObjectNode report) {
    int removed = 0;
    for (JsonNode list : report) {
      if (list instanceof ArrayNode entries) {
        for (; entries.size() > MOST_ENTRIES; removed++) {
          entries.remove(entries.size() - 1);
        }
      }
    }
    return removed;
  }

  /** Fails if the command has read a file outside: a model may refer to any. */
  private static void requireInside(ObjectNode report, Path folder) {
    List<String> files = new ArrayList<>();
    report.path("files").forEach(file -> files.add(file.asText()));
    report.path("findings").forEach(finding -> files.add(finding.path("file").asText()));
    for (String file : files) {
      if (!folder.resolve(file).normalize().startsWith(folder)) {
        throw outside(file);
      }
    }
  }

  private static DiagnosticException outside(String file) {
    return McpRules.refusal(
        McpRules.OUTSIDE,
        file,
        "The project refers to a file outside the folder of the server; what is said about it is not sent.",
        "Start the server in a folder that holds both, or remove the reference.");
  }

  private static String textOf(Ended ended) {
    return shortened(ended.err() + ended.out());
  }

  private static String shortened(String text) {
    if (text.length() <= HEAD + TAIL) {
      return text;
    }
    int left = text.length() - HEAD - TAIL;
    return text.substring(0, HEAD)
        + "\n... "
        + left
        + " characters are left out here ...\n"
        + text.substring(text.length() - TAIL);
  }
}
