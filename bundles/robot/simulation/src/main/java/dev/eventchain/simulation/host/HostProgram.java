package dev.eventchain.simulation.host;

import dev.eventchain.sandbox.ConfinedProcess;
import dev.eventchain.sandbox.Confinement;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.sandbox.PythonSources;
import dev.eventchain.sandbox.WorkFolder;
import dev.eventchain.simulation.node.NodePackage;
import java.nio.file.Path;
import java.time.Duration;

/**
 * The ROS 2 runtime's programs that host nodes.
 *
 * @param generated the nodes that they run, within their limits
 */
public record HostProgram(
    NodePackage generated, PythonEnvironment python, Confinement confinement) {

  /** Where the ROS 2 runtime's Python sources are among the resources. */
  private static final String RUNTIME = "eventchain/ros2";

  private static final int MEMORY_MIB = 1024;

  /** The files that the user's code is in. */
  public UserFiles userFiles() {
    return new UserFiles(generated.folder());
  }

  /**
   * A process of a program, to be started: it may read the package and the message definitions.
   *
   * @param module the program
   * @param turn which of the processes that run at the same time it is
   */
  public ConfinedProcess.Builder process(String module, int turn, WorkFolder workFolder) {
    Path runtime = PythonSources.unpack(HostProgram.class.getClassLoader(), RUNTIME);
    Duration longest = generated.limits().run();
    return ConfinedProcess.on(python)
        .module(module)
        .pythonPath(runtime)
        .readable(generated.messages(), generated.folder())
        .workFolder(workFolder.path())
        .components(turn)
        .limits(new ConfinedProcess.Limits(longest, longest, MEMORY_MIB))
        .confinement(confinement);
  }
}
