package dev.eventchain.simulation.wire;

import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import org.junit.jupiter.api.Test;

class DdsDomainTest {

  @Test
  void aDomainThatSomebodyIsInIsNotTaken() throws Exception {
    DdsDomain first = DdsDomain.find();
    assertTrue(first.number() >= 1 && first.number() <= 100, first::toString);
    int port = 7400 + 250 * first.number() + 10;
    InetAddress loopback = InetAddress.getLoopbackAddress();
    try (DatagramSocket taken = new DatagramSocket(new InetSocketAddress(loopback, port))) {
      assertTrue(taken.isBound());
      DdsDomain second = DdsDomain.find();
      assertNotEquals(first.number(), second.number());
      assertNotEquals(first.tag(), second.tag());
      second.release();
    }
    DdsDomain third = DdsDomain.find();
    assertNotEquals(first.number(), third.number(), "this process has it already");
    third.release();
    first.release();
  }
}
