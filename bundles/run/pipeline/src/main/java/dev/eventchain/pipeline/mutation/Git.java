package dev.eventchain.pipeline.mutation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/** Git in a folder. It answers in a limited time, also where a lock or a network holds it up. */
final class Git {

  private final List<String> program;
  private final Path folder;
  private final Duration limit;

  /** Output of Git. */
  record Answer(int exitCode, String text) {}

  /**
   * Prepares Git.
   *
   * @param program the command before Git's own arguments
   * @param limit the time that an answer may take
   */
  Git(List<String> program, Path folder, Duration limit) {
    this.program = List.copyOf(program);
    this.folder = folder;
    this.limit = limit;
  }

  /**
   * Asks for an answer.
   *
   * @throws DiagnosticException UNAVAILABLE, {@code mutation.since}, if there is no Git or it does
   *     not answer in time
   */
  Answer ask(String... arguments) {
    List<String> command = new ArrayList<>(program);
    command.addAll(List.of(arguments));
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    builder.redirectError(ProcessBuilder.Redirect.DISCARD);
    try {
      Process process = builder.start();
      process.getOutputStream().close();
      CompletableFuture<String> text =
          CompletableFuture.supplyAsync(() -> read(process.getInputStream()));
      if (!process.waitFor(limit.toMillis(), TimeUnit.MILLISECONDS)) {
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        process.destroyForcibly();
        throw failure("'git " + arguments[0] + "' has not answered in " + seconds() + " s.");
      }
      return new Answer(process.exitValue(), text.join());
    } catch (IOException e) {
      throw failure("There is no Git, which --since needs.");
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }

  private long seconds() {
    return limit.toSeconds();
  }

  private static String read(InputStream output) {
    try (output) {
      return new String(output.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private DiagnosticException failure(String message) {
    return failure(DiagnosticException.Reason.UNAVAILABLE, message);
  }

  /** Returns the failure to compare. */
  DiagnosticException failure(DiagnosticException.Reason reason, String message) {
    return new DiagnosticException(
        reason,
        Diagnostic.of(MutationRules.MUTATION_SINCE, message, SourceLocation.of(folder))
            .withHint("Leave out --since to try all mutants."));
  }
}
