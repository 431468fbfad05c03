package dev.eventchain.simulation;

import dev.eventchain.python.ConfinedProcess;
import dev.eventchain.python.Confinement;
import dev.eventchain.python.PythonEnvironment;
import dev.eventchain.python.PythonSources;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;

/** A confined Python process with the lock-step host of the ROS 2 runtime in it. */
final class LockstepProcess implements AutoCloseable {

  /** Where the ROS 2 runtime's Python sources are among the resources. */
  private static final String RUNTIME = "eventchain/ros2";

  private static final String HOST = "eventchain_ros2.lockstep";
  private static final int MEMORY_MIB = 1024;

  /** An upper bound for a whole suite; hanging is found by the step limit long before. */
  private static final Duration LONGEST = Duration.ofMinutes(60);

  private final Path workFolder;
  private final ConfinedProcess process;
  private final Watchdog watchdog;
  private final LockstepSession session;

  LockstepProcess(SimulationRequest request, PythonEnvironment python, Confinement confinement) {
    this.workFolder = temporaryFolder();
    Path runtime = PythonSources.unpack(LockstepProcess.class.getClassLoader(), RUNTIME);
    List<Path> readable = new ArrayList<>(request.messageFolders());
    readable.add(request.packageFolder());
    this.process =
        ConfinedProcess.on(python)
            .module(HOST)
            .pythonPath(runtime)
            .readable(readable.toArray(Path[]::new))
            .workFolder(workFolder)
            .limits(new ConfinedProcess.Limits(LONGEST, LONGEST, MEMORY_MIB))
            .confinement(confinement)
            .start();
    // The host itself interrupts Python code that takes too long, and says where it was; this is
    // for
    // code that cannot be interrupted.
    this.watchdog = new Watchdog(request.stepLimit().plusSeconds(2), process::close);
    this.session =
        new LockstepSession(
            new LockstepChannel(process.stdout(), process.stdin()),
            watchdog,
            this::standardError,
            new UserFiles(request.packageFolder()));
  }

  private static Path temporaryFolder() {
    try {
      return Files.createTempDirectory("eventchain-simulation");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  LockstepSession session() {
    return session;
  }

  private String standardError() {
    process.close();
    process.await();
    return process.standardError();
  }

  @Override
  public void close() {
    watchdog.close();
    process.close();
    try {
      Files.deleteIfExists(workFolder);
    } catch (IOException e) {
      workFolder.toFile().deleteOnExit(); // nodes left files in it: not worth failing for
    }
  }
}
