package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.sandbox.ConfinedProcess;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.sandbox.PythonSources;
import dev.eventchain.sandbox.WorkFolder;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;

/** Reads the sources of a workspace in a confined process, which runs none of them. */
final class SourceReader {

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final String PROGRAM = "workspace_sources.py";
  private static final ConfinedProcess.Limits LIMITS =
      new ConfinedProcess.Limits(Duration.ofMinutes(5), Duration.ofMinutes(2), 2048);
  private static final int MAXIMAL_OUTPUT = 64 << 20;

  private SourceReader() {}

  /**
   * Returns what the sources say, as the program does.
   *
   * @throws DiagnosticException INPUT ({@code workspace.unread}) if the program does not end as it
   *     should
   */
  static JsonNode read(PythonEnvironment environment, Path workspace, JsonNode request) {
    try (WorkFolder folder = WorkFolder.create()) {
      return read(environment, workspace, request, folder);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static JsonNode read(
      PythonEnvironment environment, Path workspace, JsonNode request, WorkFolder folder)
      throws IOException {
    var programs =
        PythonSources.unpack(SourceReader.class.getClassLoader(), "dev/eventchain/workspace");
    var shared =
        PythonSources.unpack(PythonSources.class.getClassLoader(), "dev/eventchain/sandbox");
    try (ConfinedProcess process =
        ConfinedProcess.on(environment)
            .script(programs.resolve(PROGRAM))
            .pythonPath(programs, shared)
            .workFolder(folder.path())
            .limits(LIMITS)
            .start()) {
      ConfinedProcess.Answer answer = process.ask(JSON.writeValueAsBytes(request), MAXIMAL_OUTPUT);
      if (!answer.end().isSuccess()) {
        throw unfinished(workspace, answer.standardError().strip());
      }
      return JSON.readTree(answer.output());
    }
  }

  private static DiagnosticException unfinished(Path workspace, String errors) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(
                WorkspaceRules.UNREAD,
                "The sources of the workspace could not be read to the end.",
                SourceLocation.of(workspace))
            .withHint(errors.isEmpty() ? "No reason was given." : "The last output:\n" + errors));
  }
}
