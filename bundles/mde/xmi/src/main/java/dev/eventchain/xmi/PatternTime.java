package dev.eventchain.xmi;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.text.CharacterIterator;
import java.text.StringCharacterIterator;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EValidator.PatternMatcher;
import org.eclipse.emf.ecore.xml.type.internal.RegEx.RegularExpression;

/**
 * The limited processor time of patterns, since regular expressions may backtrack endlessly. For
 * one thread.
 */
final class PatternTime {

  /** Thrown when a pattern is abandoned. */
  static final class SpentException extends RuntimeException {

    private static final long serialVersionUID = 1L;

    private SpentException() {
      super("the time for patterns is used up", null, false, false);
    }
  }

  /** Number of types that may use up their time. */
  private static final int SLOW_TYPES = 4;

  /** Nanoseconds between readings of the processor clock, which are as slow as a short match. */
  private static final long BETWEEN_READINGS = 20_000_000;

  private static final int STEPS_BETWEEN_LOOKS = 64;
  private static final long UNKNOWN = Long.MIN_VALUE;

  private final long limit;
  private final Map<EDataType, Long> used = new HashMap<>();
  private final Map<String, RegularExpression> compiled = new HashMap<>();
  private long usedByAll;
  private EDataType type;

  /** The last reading of the processor clock; time used since then is not charged yet. */
  private long reading = UNKNOWN;

  /** The wall time of matching since then, except for the current match. */
  private long matching;

  /** The time of the last check of the current match. */
  private long started;

  PatternTime(Duration limit) {
    this.limit = limit.toNanos();
  }

  /** Charges the time from now on to a type. */
  void use(EDataType of) {
    type = of;
  }

  boolean isSpent(EDataType of) {
    return used.getOrDefault(of, 0L) >= limit || isSpentByAll();
  }

  /** Returns the exceeded limit, for a message. */
  String shortage() {
    long millis = (isSpentByAll() ? SLOW_TYPES * limit : limit) / 1_000_000;
    String amount = millis % 1000 == 0 ? millis / 1000 + " s" : millis + " ms";
    String purpose = isSpentByAll() ? "the patterns of all types take" : "its patterns take";
    return purpose + " more than " + amount + " of processor time";
  }

  private boolean isSpentByAll() {
    return usedByAll >= SLOW_TYPES * limit;
  }

  /** Returns patterns that throw {@link SpentException} when the time is spent. */
  PatternMatcher[][] watched(PatternMatcher[][] patterns) {
    PatternMatcher[][] watched = new PatternMatcher[patterns.length][];
    for (int i = 0; i < patterns.length; i++) {
      watched[i] = new PatternMatcher[patterns[i].length];
      for (int j = 0; j < patterns[i].length; j++) {
        String pattern = patterns[i][j].toString();
        watched[i][j] = text -> matches(pattern, text);
      }
    }
    return watched;
  }

  private boolean matches(String pattern, String text) {
    // The option is that of XML Schema, which EMF uses, too.
    RegularExpression expression =
        compiled.computeIfAbsent(pattern, each -> new RegularExpression(each, "X"));
    started = System.nanoTime();
    if (reading == UNKNOWN) {
      reading = processorNanos();
    }
    try {
      return expression.matches(new Watched(text));
    } finally {
      look();
    }
  }

  /** Charges the time since the last reading, if that may be much. */
  private void look() {
    long now = System.nanoTime();
    matching += now - started;
    started = now;
    if (matching >= BETWEEN_READINGS) {
      long processor = processorNanos();
      // Processor time includes other work of this thread, wall time includes other threads.
      long taken = Math.min(processor - reading, matching);
      used.merge(type, taken, Long::sum);
      usedByAll += taken;
      reading = processor;
      matching = 0;
    }
  }

  /** A text that checks the time when its characters are read. */
  private final class Watched implements CharacterIterator {

    private final StringCharacterIterator text;
    private int steps;

    private Watched(String text) {
      this.text = new StringCharacterIterator(text);
    }

    @Override
    public char setIndex(int position) {
      if (++steps % STEPS_BETWEEN_LOOKS == 0) {
        look();
        if (isSpent(type)) {
          throw new SpentException();
        }
      }
      return text.setIndex(position);
    }

    @Override
    public char first() {
      return setIndex(getBeginIndex());
    }

    @Override
    public char last() {
      return text.last();
    }

    @Override
    public char current() {
      return text.current();
    }

    @Override
    public char next() {
      return text.next();
    }

    @Override
    public char previous() {
      return text.previous();
    }

    @Override
    public int getBeginIndex() {
      return text.getBeginIndex();
    }

    @Override
    public int getEndIndex() {
      return text.getEndIndex();
    }

    @Override
    public int getIndex() {
      return text.getIndex();
    }

    @Override
    public Object clone() {
      return text.clone();
    }
  }

  /** Returns the processor time of this thread; wall time if Java cannot measure it. */
  private static long processorNanos() {
    return Processor.BEAN == null ? System.nanoTime() : Processor.BEAN.getCurrentThreadCpuTime();
  }

  /** Loaded on first use, which takes some milliseconds. */
  private static final class Processor {

    private static final ThreadMXBean BEAN = find();

    private Processor() {}

    private static ThreadMXBean find() {
      ThreadMXBean bean = ManagementFactory.getThreadMXBean();
      return bean.isCurrentThreadCpuTimeSupported() && bean.isThreadCpuTimeEnabled() ? bean : null;
    }
  }
}
