package dev.eventchain.simulation;

import dev.eventchain.sandbox.ConfinedProcess;
import dev.eventchain.sandbox.Confinement;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.sandbox.PythonSources;
import dev.eventchain.sandbox.WorkFolder;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;

/**
 * The ROS 2 runtime's programs that host nodes.
 *
 * @param request whose nodes they run, within its limits
 */
record HostProgram(SimulationRequest request, PythonEnvironment python, Confinement confinement) {

  /** Where the ROS 2 runtime's Python sources are among the resources. */
  private static final String RUNTIME = "eventchain/ros2";

  private static final int MEMORY_MIB = 1024;

  /**
   * A process of a program, to be started: it may read the package and the message definitions.
   *
   * @param module the program
   * @param turn which of the processes that run at the same time it is
   */
  ConfinedProcess.Builder process(String module, int turn, WorkFolder workFolder) {
    Path runtime = PythonSources.unpack(HostProgram.class.getClassLoader(), RUNTIME);
    List<Path> readable = new ArrayList<>(request.messageFolders());
    readable.add(request.packageFolder());
    Duration longest = request.limits().run();
    return ConfinedProcess.on(python)
        .module(module)
        .pythonPath(runtime)
        .readable(readable.toArray(Path[]::new))
        .workFolder(workFolder.path())
        .components(turn)
        .limits(new ConfinedProcess.Limits(longest, longest, MEMORY_MIB))
        .confinement(confinement);
  }
}
