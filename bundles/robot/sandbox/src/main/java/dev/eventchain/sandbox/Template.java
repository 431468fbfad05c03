package dev.eventchain.sandbox;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.MissingNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * An interpreter that has imported what confined processes need, and is forked for each of them,
 * which takes a quarter of the time of a new one. See {@code template.py}, which confines each fork
 * as if it were new.
 *
 * <p>A template is started when a second process of its kind is wanted. Where it does not work, new
 * interpreters are started as before.
 */
final class Template {

  /**
   * Properties that all processes of a template share.
   *
   * @param pythonPath folders with Eventchain's packages
   * @param modules the modules that are imported besides Eventchain's own
   */
  record Kind(
      Path executable, Path harness, int hashSeed, List<Path> pythonPath, Set<String> modules) {

    private List<String> line() {
      ObjectNode description = JSON.createObjectNode();
      description.put("parent", ProcessHandle.current().pid());
      description.put("programs", System.getenv().getOrDefault("PATH", ""));
      ArrayNode path = description.putArray("path");
      pythonPath.forEach(folder -> path.add(folder.toString()));
      ArrayNode names = description.putArray("modules");
      modules.stream().sorted().forEach(names::add);
      return List.of(
          executable.toString(), "-c", START, harness.toString(), description.toString());
    }
  }

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final String START =
      """
      import sys; sys.path.insert(0, sys.argv[1]); import confined, template; \
      confined.main(template.main(sys.argv[2]))""";
  private static final int KILLED = 128 + 9;
  private static final long PATIENCE_SECONDS = 60;

  private static final Set<Kind> WANTED = new HashSet<>();
  private static final Map<Kind, Optional<Template>> STARTED = new HashMap<>();

  private final Process process;
  private final OutputStream requests;
  private final BlockingQueue<JsonNode> answers = new LinkedBlockingQueue<>();
  private final Map<Integer, ForkedProcess> running = new ConcurrentHashMap<>();
  private int number;
  private volatile boolean usable = true;

  private Template(Process process) {
    this.process = process;
    this.requests = process.getOutputStream();
    ProcessThreads.daemon(this::listen, "confined-process-template").start();
  }

  /** Starts a process; empty if a new interpreter has to be started for it. */
  static Optional<Process> start(Kind kind, ConfinedCommand command) {
    return of(kind).flatMap(template -> template.fork(command));
  }

  private static Optional<Template> of(Kind kind) {
    synchronized (STARTED) {
      return WANTED.add(kind)
          ? Optional.empty()
          : STARTED.computeIfAbsent(kind, Template::start).filter(template -> template.usable);
    }
  }

  private static Optional<Template> start(Kind kind) {
    ProcessBuilder builder = new ProcessBuilder(kind.line());
    builder.environment().clear();
    builder.environment().putAll(ConfinedCommand.settings("/", kind.hashSeed()));
    builder.directory(kind.harness().toFile()); // some Pythons import from the current folder
    builder.redirectError(ProcessBuilder.Redirect.DISCARD);
    try {
      return Optional.of(new Template(ProcessThreads.start(builder)));
    } catch (IOException e) {
      return Optional.empty(); // the new interpreter tells why
    }
  }

  /** Receives answers until there are no more. */
  private void listen() {
    try (BufferedReader lines = process.inputReader(StandardCharsets.UTF_8)) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        JsonNode answer = JSON.readTree(line);
        if (answer.path(0).asText().equals("ended")) {
          ended(answer.path(1).asInt(), answer.path(2).asInt());
        } else {
          answers.add(answer);
        }
      }
    } catch (IOException e) {
      process.destroyForcibly(); // its processes end with it
    }
    usable = false;
    answers.add(MissingNode.getInstance());
    running.keySet().forEach(each -> ended(each, KILLED));
  }

  private void ended(int which, int exitCode) {
    ForkedProcess forked = running.remove(which);
    if (forked != null) {
      forked.ended(exitCode);
    }
  }

  private synchronized Optional<Process> fork(ConfinedCommand command) {
    number++;
    ArrayNode request = JSON.createArrayNode().add("start").add(number);
    List<String> enclosure = command.enclosure();
    request.add(enclosure.isEmpty() ? null : JSON.valueToTree(enclosure));
    request.add(command.description());
    try {
      send(request);
      JsonNode made = answer();
      if (!made.path(0).asText().equals("made")) {
        throw new IOException(made.path(2).asText());
      }
      return Optional.of(open(made));
    } catch (IOException e) {
      usable = false; // what does not work once will not work the next time
      return Optional.empty();
    }
  }

  private Process open(JsonNode made) throws IOException {
    JsonNode ends = made.path(3);
    try {
      ForkedProcess forked =
          new ForkedProcess(
              made.path(2).asLong(),
              "/proc/" + process.pid() + "/fd/",
              ends.path(0).asInt(),
              ends.path(1).asInt(),
              ends.path(2).asInt());
      running.put(number, forked);
      send(JSON.createArrayNode().add("go").add(number));
      return forked;
    } catch (IOException e) {
      send(JSON.createArrayNode().add("drop").add(number));
      throw e;
    }
  }

  private void send(ArrayNode request) throws IOException {
    requests.write((request + "\n").getBytes(StandardCharsets.UTF_8));
    requests.flush();
  }

  /** Waits for the answer, even if this thread is interrupted: the process must not be lost. */
  private JsonNode answer() throws IOException {
    boolean interrupted = false;
    try {
      while (true) {
        try {
          JsonNode answer = answers.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
          if (answer == null) {
            send(JSON.createArrayNode().add("drop").add(number)); // should it ever answer
            throw new IOException("it does not answer");
          }
          return answer;
        } catch (InterruptedException e) {
          interrupted = true;
        }
      }
    } finally {
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }
}
