package dev.eventchain.llm.handoff;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.llm.chat.ChatModel;
import dev.eventchain.llm.chat.ChatRequest;
import dev.eventchain.llm.chat.ChatResponse;
import dev.eventchain.llm.chat.ChatResponse.FinishReason;
import dev.eventchain.llm.chat.ModelName;
import dev.eventchain.llm.service.BodyStream;
import dev.eventchain.llm.service.Deadline;
import dev.eventchain.llm.service.ErrorBody;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Asks a program of the user, which gets the prompt on standard input and gives the answer on
 * standard output, in UTF-8. Exit code 0 marks a complete answer.
 */
public final class CommandModel implements ChatModel {
  static final String PROVIDER = "command";

  /** An argument; arguments are separated by blanks outside quotes. */
  private static final Pattern ARGUMENT = Pattern.compile("\"([^\"]*)\"|'([^']*)'|([^\\s\"']+)");

  private static final int LONGEST_COMPLAINT = 64 << 10;

  private final ModelName name;
  private final List<String> command;
  private final Duration allowed;

  public CommandModel(ModelName name, List<String> command, Duration allowed) {
    this.name = name;
    this.command = command;
    this.allowed = allowed;
  }

  /**
   * Splits a command into the program and its arguments; empty if it names none, such as {@code
   * ''}.
   */
  public static List<String> split(String command) {
    List<String> parts = new ArrayList<>();
    Matcher matcher = ARGUMENT.matcher(command);
    while (matcher.find()) {
      for (int group = 1; group <= matcher.groupCount(); group++) {
        if (matcher.group(group) != null) {
          parts.add(matcher.group(group));
        }
      }
    }
    return parts.isEmpty() || parts.get(0).isBlank() ? List.of() : parts;
  }

  @Override
  public ChatResponse chat(ChatRequest request) {
    Process process = start();
    // A signal ends this JVM without its finally blocks.
    Thread end = new Thread(() -> end(process), "end of a command");
    Runtime.getRuntime().addShutdownHook(end);
    try {
      return answer(process, request);
    } catch (InterruptedException e) {
      throw Deadline.in(allowed).interrupted();
    } finally {
      end(process);
      forget(end);
    }
  }

  private ChatResponse answer(Process process, ChatRequest request) throws InterruptedException {
    CompletableFuture<String> answer = read(process.getInputStream(), BodyStream.LONGEST);
    CompletableFuture<String> complaint = read(process.getErrorStream(), LONGEST_COMPLAINT);
    feed(process.getOutputStream(), HandoffPrompt.conversationWithSchema(request));
    if (!process.waitFor(allowed.toMillis(), TimeUnit.MILLISECONDS)) {
      throw failed("did not end within " + Deadline.text(allowed), "");
    }
    if (process.exitValue() != 0) {
      throw failed("ended with exit code " + process.exitValue(), complaint.join());
    }
    String text = answer.join();
    if (text.isBlank()) {
      throw failed("wrote nothing to standard output", complaint.join());
    }
    return new ChatResponse(text, FinishReason.STOP, name.name(), PROVIDER, Optional.empty());
  }

  private static void forget(Thread end) {
    try {
      Runtime.getRuntime().removeShutdownHook(end);
    } catch (IllegalStateException e) {
      // The JVM is ending, and the hook kills the process.
    }
  }

  private static void end(Process process) {
    process.descendants().forEach(ProcessHandle::destroyForcibly);
    process.destroyForcibly();
  }

  private Process start() {
    try {
      return new ProcessBuilder(command).start();
    } catch (IOException e) {
      throw failed("cannot be started: " + SourceText.reason(e), "");
    }
  }

  private static void feed(OutputStream input, String prompt) {
    try (input) {
      input.write(prompt.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      // A program need not read all of its input; its exit code tells whether it answered.
    }
  }

  private static CompletableFuture<String> read(InputStream stream, long most) {
    return CompletableFuture.supplyAsync(
        () -> {
          try (stream) {
            return new String(stream.readNBytes((int) most), StandardCharsets.UTF_8);
          } catch (IOException e) {
            return ""; // Its process has been killed, and the output is not needed.
          }
        },
        task -> {
          Thread thread = new Thread(task, "answer of a command");
          thread.setDaemon(true);
          thread.start();
        });
  }

  private DiagnosticException failed(String how, String complaint) {
    String said = complaint.isBlank() ? "" : ": " + ErrorBody.shown(complaint);
    return new DiagnosticException(
        Reason.UNAVAILABLE,
        Diagnostic.of(
                HandoffRules.COMMAND_FAILED,
                "The command '%s' %s%s".formatted(command.get(0), how, said),
                SourceLocation.NONE)
            .withHint(
                "It gets the prompt on standard input, and must write the answer to standard output"
                    + " and end with exit code 0."));
  }
}
