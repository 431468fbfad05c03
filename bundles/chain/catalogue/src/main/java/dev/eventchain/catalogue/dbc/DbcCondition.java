package dev.eventchain.catalogue.dbc;

import java.math.BigDecimal;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Numbers of a multiplexer with which a signal is in its message.
 *
 * @param multiplexer the signal whose value decides
 * @param ranges its raw numbers, of which one is enough
 */
record DbcCondition(DbcSignal multiplexer, List<Range> ranges) {

  /** Raw numbers from one to another, both included. */
  record Range(BigDecimal from, BigDecimal to) {

    static Range of(BigDecimal number) {
      return new Range(number, number);
    }

    boolean isOneNumber() {
      return from.compareTo(to) == 0;
    }

    /** Returns the range in physical values, the least first. */
    private String physical(DbcSignal.Layout layout) {
      BigDecimal one = layout.physical(from);
      BigDecimal other = layout.physical(to);
      if (one.compareTo(other) == 0) {
        return DbcValues.plain(one);
      }
      BigDecimal least = one.min(other);
      String between = least.signum() < 0 ? " to " : "-";
      return DbcValues.plain(least) + between + DbcValues.plain(one.max(other));
    }
  }

  /** Copies the list. */
  DbcCondition {
    ranges = List.copyOf(ranges);
  }

  /** Returns the condition in physical values, such as "Mux is 0-3, 5". */
  String text() {
    return ranges.stream()
        .map(range -> range.physical(multiplexer.layout()))
        .collect(Collectors.joining(", ", multiplexer.name() + " is ", ""));
  }
}
