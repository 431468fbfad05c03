package dev.eventchain.pipeline.mutation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests a Git that does not answer, in place of which another program is started. */
class GitTest {

  @TempDir private Path folder;

  private Git program(Duration limit, String... command) {
    return new Git(List.of(command), folder, limit);
  }

  private static Diagnostic refusal(Git git) {
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> git.ask("diff", "--stat"));
    assertEquals(DiagnosticException.Reason.UNAVAILABLE, refused.reason());
    assertEquals("mutation.since", refused.diagnostics().get(0).id());
    return refused.diagnostics().get(0);
  }

  @Test
  void anAnswerHasAnExitCodeAndAText() {
    Git.Answer answer = program(Duration.ofMinutes(5), "sh", "-c", "echo $0; exit 4").ask("diff");
    assertEquals(4, answer.exitCode());
    assertEquals("diff\n", answer.text());
  }

  @Test
  void oneThatNeverAnswersIsNotWaitedFor() {
    Diagnostic found = refusal(program(Duration.ofMillis(20), "sh", "-c", "sleep 100000; true"));
    assertEquals("'git diff' has not answered in 0 s.", found.message());
  }

  @Test
  void oneThatIsNotThereIsNamed() {
    Diagnostic found = refusal(program(Duration.ofMinutes(5), "no-such-git-anywhere"));
    assertTrue(found.message().startsWith("There is no Git"), found.message());
  }
}
