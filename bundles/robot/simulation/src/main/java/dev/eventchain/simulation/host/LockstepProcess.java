package dev.eventchain.simulation.host;

import dev.eventchain.sandbox.ConfinedProcess;
import dev.eventchain.sandbox.WorkFolder;
import dev.eventchain.simulation.node.NodeLimits;

/** A confined Python process with the lock-step host of the ROS 2 runtime. */
public final class LockstepProcess implements NodeHosts {

  private static final String HOST = "eventchain_ros2.lockstep";

  private final WorkFolder workFolder = WorkFolder.create();
  private final ConfinedProcess process;
  private final Watchdog watchdog;
  private final LockstepSession session;

  /**
   * Starts the process.
   *
   * @param nodes the maximum number of its nodes
   * @param turn the index among parallel processes
   */
  public LockstepProcess(HostProgram program, int nodes, int turn) {
    this.process = program.process(HOST, turn, workFolder).start();
    this.watchdog = watchdog(program.generated().limits(), nodes + 1, process);
    this.session =
        new LockstepSession(
            new HostChannel(process.stdout(), process.stdin()),
            watchdog,
            new HostFailures(
                "The process that runs the nodes",
                () -> HostFailures.LastWords.of(process),
                program.userFiles()));
  }

  /**
   * Creates the watchdog for code that the host cannot interrupt. The host itself ends slow
   * components and nodes and reports their location; the limit allows for all of them in sequence.
   */
  private static Watchdog watchdog(NodeLimits limits, int all, ConfinedProcess process) {
    return new Watchdog(
        limits.processorTime().multipliedBy(all).plusSeconds(2),
        limits.wallTime().multipliedBy(all).plusSeconds(10),
        process::processorTime,
        process::close);
  }

  @Override
  public NodeSession session() {
    return session;
  }

  @Override
  public void close() {
    watchdog.close();
    process.close();
    workFolder.close();
  }
}
