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
 * Programs of the ROS 2 runtime that host nodes.
 *
 * @param generated the nodes to run, with their limits
 * @param hashSeed the seed of Python's hashes, which decides about the order of sets
 */
public record HostProgram(
    NodePackage generated, PythonEnvironment python, Confinement confinement, int hashSeed) {

  /** Path of the ROS 2 runtime's Python sources among the resources. */
  private static final String RUNTIME = "eventchain/ros2";

  private static final int MEMORY_MIB = 1024;

  /** Creates programs with the hash seed 0. */
  public HostProgram(NodePackage generated, PythonEnvironment python, Confinement confinement) {
    this(generated, python, confinement, 0);
  }

  /** Returns the same programs with another seed of Python's hashes. */
  public HostProgram withHashSeed(int seed) {
    return new HostProgram(generated, python, confinement, seed);
  }

  /** Returns the files with the user's code. */
  public UserFiles userFiles() {
    return new UserFiles(generated.folder());
  }

  /**
   * Returns a process to start, which may read the package and the message definitions.
   *
   * @param module the module of the program
   * @param turn the index among parallel processes
   */
  public ConfinedProcess.Builder process(String module, int turn, WorkFolder workFolder) {
    Path runtime = PythonSources.unpack(HostProgram.class.getClassLoader(), RUNTIME);
    Duration longest = generated.limits().run();
    return ConfinedProcess.on(python)
        .module(module)
        .pythonPath(runtime)
        .readable(generated.messages(), generated.folder())
        .readable(generated.variants().toArray(Path[]::new))
        .workFolder(workFolder.path())
        .components(turn, componentFiles())
        .hashSeed(hashSeed)
        .limits(new ConfinedProcess.Limits(longest, longest, MEMORY_MIB))
        .confinement(confinement);
  }

  private Path[] componentFiles() {
    return generated.manifest().nodes().stream()
        .flatMap(
            node -> node.component().map(known -> generated.componentFile(node, known)).stream())
        .toArray(Path[]::new);
  }
}
