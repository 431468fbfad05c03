package dev.eventchain.simulation.wire;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.dds.DdsLibrary;
import dev.eventchain.dds.DdsParticipant;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.sandbox.ConfinedProcess;
import dev.eventchain.sandbox.WorkFolder;
import dev.eventchain.simulation.host.HostProgram;
import dev.eventchain.simulation.host.NodeHosts;
import dev.eventchain.simulation.host.NodeSession;
import dev.eventchain.simulation.host.UserFiles;
import dev.eventchain.simulation.node.NodeLimits;
import java.util.ArrayList;
import java.util.List;

/** A confined process for each node of a chain, and the world, in a separate DDS domain. */
public final class DdsHosts implements NodeHosts {

  private static final String HOST = "eventchain_ros2.node_host";
  private static final String PREPARATION = "eventchain_ros2.preparation";

  private final HostProgram program;
  private final DdsDomain domain = DdsDomain.find();
  private final List<NodeProcess> nodes = new ArrayList<>();
  private final DdsParticipant participant;
  private final DdsSession session;

  /**
   * Starts the processes.
   *
   * @param program a program whose Python has Cyclone DDS
   * @param names of the nodes, in chain order
   * @param catalog the message types that the nodes use
   * @param inRealTime true if no node waits for another
   * @param turn the index among parallel groups of processes
   */
  public DdsHosts(
      HostProgram program,
      List<String> names,
      MessageCatalog catalog,
      boolean inRealTime,
      int turn) {
    this.program = program;
    UserFiles files = program.userFiles();
    NodeLimits limits = program.generated().limits();
    participant = enter();
    try {
      participant.announce("eventchain_world");
      for (String name : names) {
        nodes.add(start(name, turn * names.size() + nodes.size(), files));
      }
      session =
          inRealTime
              ? new RealTimeSession(nodes, participant, catalog, files, limits)
              : new SimulatedTimeSession(nodes, participant, catalog, files, limits);
    } catch (RuntimeException | Error e) {
      closeAll();
      throw e;
    }
  }

  private DdsParticipant enter() {
    try {
      DdsLibrary library = DdsLibrary.load(program.python().cycloneDds());
      return DdsParticipant.loopback(library, domain.number(), domain.tag());
    } catch (RuntimeException | Error e) {
      domain.release();
      throw e;
    }
  }

  private NodeProcess start(String name, int turn, UserFiles files) {
    WorkFolder workFolder = WorkFolder.create();
    try {
      ConfinedProcess process =
          program.process(HOST, turn, workFolder).preparation(PREPARATION, preparation()).start();
      return new NodeProcess(name, process, workFolder, files);
    } catch (RuntimeException | Error e) {
      workFolder.close();
      throw e;
    }
  }

  private ObjectNode preparation() {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("domain", domain.number());
    json.put("configuration", DdsParticipant.loopbackConfiguration(domain.tag()));
    json.putArray("messages").add(program.generated().messages().toString());
    return json;
  }

  @Override
  public NodeSession session() {
    return session;
  }

  @Override
  public void close() {
    closeAll();
  }

  /** Closes the nodes first, so that threads that wait for them are notified. */
  private void closeAll() {
    nodes.forEach(NodeProcess::close);
    participant.close();
    domain.release();
  }
}
