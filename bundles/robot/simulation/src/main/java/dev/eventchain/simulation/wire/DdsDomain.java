package dev.eventchain.simulation.wire;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.IntFunction;

/**
 * A DDS domain that is not in use on this machine. If two runs choose the same one at the same
 * moment, their tags keep them apart.
 *
 * @param number the domain id
 * @param tag the domain tag; only participants with the same one match
 */
public record DdsDomain(int number, String tag) {

  /** First domain: ROS 2 uses 0 by default. Ports of 101 and above are ephemeral. */
  private static final int FIRST = 1;

  private static final int LAST = 100;

  /** Domains of this process, which allows one configuration for each domain. */
  private static final Set<Integer> OURS = ConcurrentHashMap.newKeySet();

  /** DDSI-RTPS 2.5, 9.6.2.3: ports of a domain, and of its first participant. */
  private static final int PORT_BASE = 7400;

  private static final int DOMAIN_GAIN = 250;
  private static final int FIRST_PARTICIPANT = 10;

  /**
   * Finds a free domain.
   *
   * @throws DiagnosticException {@code dds.domain.none}: there is none, or no loopback interface
   */
  public static DdsDomain find() {
    return find(DdsDomain::problem);
  }

  /**
   * Finds a free domain.
   *
   * @param problem returns why a domain cannot be joined; empty if it is free
   */
  public static DdsDomain find(IntFunction<String> problem) {
    int domains = LAST - FIRST + 1;
    long start = ProcessHandle.current().pid() + Thread.currentThread().getId();
    String last = "";
    for (int i = 0; i < domains; i++) {
      int number = FIRST + (int) ((start + i) % domains);
      last = OURS.contains(number) ? "this program uses it" : problem.apply(number);
      if (last.isEmpty() && OURS.add(number)) {
        return new DdsDomain(number, UUID.randomUUID().toString());
      }
    }
    throw new DiagnosticException(
        DiagnosticException.Reason.UNAVAILABLE,
        Diagnostic.of(
                WireRules.DDS_DOMAIN_NONE,
                "No DDS domain from " + FIRST + " to " + LAST + " is free: " + last + ".",
                SourceLocation.NONE)
            .withHint("Is the loopback interface up? Nothing else is needed."));
  }

  /** Releases the domain. */
  public void release() {
    OURS.remove(number);
  }

  private static String problem(int number) {
    int port = PORT_BASE + DOMAIN_GAIN * number + FIRST_PARTICIPANT;
    InetAddress loopback = InetAddress.getLoopbackAddress();
    try (DatagramSocket socket = new DatagramSocket(new InetSocketAddress(loopback, port))) {
      return socket.isBound() ? "" : "it cannot be bound";
    } catch (IOException e) {
      return SourceText.reason(e);
    }
  }
}
