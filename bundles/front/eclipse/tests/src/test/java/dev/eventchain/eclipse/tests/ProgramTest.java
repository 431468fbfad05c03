package dev.eventchain.eclipse.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.eclipse.EventchainCore;
import dev.eventchain.eclipse.Preferences;
import dev.eventchain.eclipse.Program;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.NullProgressMonitor;
import org.eclipse.core.runtime.OperationCanceledException;
import org.eclipse.core.runtime.preferences.IEclipsePreferences;
import org.eclipse.core.runtime.preferences.InstanceScope;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The program {@code eventchain} as a process: found, run, cancelled. */
class ProgramTest {

  @TempDir Path folder;

  private final IEclipsePreferences preferences = InstanceScope.INSTANCE.getNode(EventchainCore.ID);

  @AfterEach
  void forget() {
    preferences.remove(Preferences.PROGRAM);
  }

  private Program script(String text) throws Exception {
    Path file = folder.resolve("eventchain");
    Files.writeString(file, "#!/bin/sh\n" + text);
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwx------"));
    preferences.put(Preferences.PROGRAM, file.toString());
    return Program.find();
  }

  @Test
  void outputAndExitCodeAreThoseOfTheProcess() throws Exception {
    StringBuffer output = new StringBuffer();
    Program program = script("echo \"$1 in $PWD\"; echo trouble >&2; exit 3\n");
    int code = program.run(List.of("run"), folder, output::append, new NullProgressMonitor());
    assertEquals(3, code);
    assertEquals("run in " + folder + "\ntrouble\n", output.toString());
  }

  @Test
  void cancelledRunIsAskedToEnd() throws Exception {
    NullProgressMonitor monitor = new NullProgressMonitor();
    Program program =
        script(
            "trap 'echo ended > ended; exit 143' TERM\necho ready\nwhile :; do sleep 0.1; done\n");
    assertThrows(
        OperationCanceledException.class,
        () -> program.run(List.of("run"), folder, text -> monitor.setCanceled(true), monitor));
    assertEquals("ended\n", Files.readString(folder.resolve("ended")));
  }

  @Test
  void programThatIsNotThereIsNamedWithWhatToDo() {
    preferences.put(Preferences.PROGRAM, folder.resolve("nothing").toString());
    CoreException failure = assertThrows(CoreException.class, Program::find);
    assertTrue(failure.getMessage().contains("Window > Preferences > Eventchain"));
  }
}
