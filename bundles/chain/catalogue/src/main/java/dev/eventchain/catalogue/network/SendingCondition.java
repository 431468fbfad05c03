package dev.eventchain.catalogue.network;

import java.math.BigDecimal;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Numbers of a multiplexer with which a signal is in its message.
 *
 * @param multiplexer the signal whose value decides
 * @param ranges its raw numbers, of which one is enough
 */
public record SendingCondition(NetworkSignal multiplexer, List<Range> ranges) {

  /** Raw numbers from one to another, both included. */
  public record Range(BigDecimal from, BigDecimal to) {

    public static Range of(BigDecimal number) {
      return new Range(number, number);
    }

    public boolean isOneNumber() {
      return from.compareTo(to) == 0;
    }

    /** Returns the range in physical values, the least first. */
    private String physical(NetworkSignal.Layout layout) {
      BigDecimal one = layout.physical(from);
      BigDecimal other = layout.physical(to);
      if (one.compareTo(other) == 0) {
        return SignalValues.plain(one);
      }
      BigDecimal least = one.min(other);
      String between = least.signum() < 0 ? " to " : "-";
      return SignalValues.plain(least) + between + SignalValues.plain(one.max(other));
    }
  }

  /** Copies the list. */
  public SendingCondition {
    ranges = List.copyOf(ranges);
  }

  /** Returns the condition in physical values, such as "Mux is 0-3, 5". */
  public String text() {
    return ranges.stream()
        .map(range -> range.physical(multiplexer.layout()))
        .collect(Collectors.joining(", ", multiplexer.name() + " is ", ""));
  }
}
