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
 * The processor time that patterns take, of which there is only so much: a regular expression may
 * try more ways through a text than anybody waits for. For one thread.
 */
final class PatternTime {

  /** A pattern was abandoned. */
  static final class SpentException extends RuntimeException {

    private static final long serialVersionUID = 1L;

    private SpentException() {
      super("the time for patterns is used up", null, false, false);
    }
  }

  /** How many types may take all of their time. */
  private static final int SLOW_TYPES = 4;

  /** The clock of the processor is expensive: it takes as long as matching a short text. */
  private static final long BETWEEN_READINGS = 20_000_000;

  private static final int STEPS_BETWEEN_LOOKS = 64;
  private static final long UNKNOWN = Long.MIN_VALUE;

  private final long limit;
  private final Map<EDataType, Long> used = new HashMap<>();
  private final Map<String, RegularExpression> compiled = new HashMap<>();
  private long usedByAll;
  private EDataType type;

  /** Of the processor's clock; what was used since then is not taken yet. */
  private long reading = UNKNOWN;

  /** The time on the wall that matching has taken since then, but for the match that continues. */
  private long matching;

  /** When the match that continues was looked at last. */
  private long started;

  PatternTime(Duration limit) {
    this.limit = limit.toNanos();
  }

  /** Takes time from what a type has, from now on. */
  void use(EDataType of) {
    type = of;
  }

  boolean isSpent(EDataType of) {
    return used.getOrDefault(of, 0L) >= limit || isSpentByAll();
  }

  /** What there is too little of, for a message. */
  String shortage() {
    long millis = (isSpentByAll() ? SLOW_TYPES * limit : limit) / 1_000_000;
    String amount = millis % 1000 == 0 ? millis / 1000 + " s" : millis + " ms";
    String purpose = isSpentByAll() ? "the patterns of all types take" : "its patterns take";
    return purpose + " more than " + amount + " of processor time";
  }

  private boolean isSpentByAll() {
    return usedByAll >= SLOW_TYPES * limit;
  }

  /** The same patterns; matching them throws {@link SpentException} when the time is spent. */
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
    // The option is that of XML Schema, by which EMF compiles patterns, too.
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

  /** Takes what was used since the last reading, if that may be much. */
  private void look() {
    long now = System.nanoTime();
    matching += now - started;
    started = now;
    if (matching >= BETWEEN_READINGS) {
      long processor = processorNanos();
      // Not all of it went into patterns, and of the time on the wall not all went into this
      // thread.
      long taken = Math.min(processor - reading, matching);
      used.merge(type, taken, Long::sum);
      usedByAll += taken;
      reading = processor;
      matching = 0;
    }
  }

  /** A text that looks at the clock when its characters are read. */
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

  /** Of this thread; wall time where Java cannot tell. */
  private static long processorNanos() {
    return Processor.BEAN == null ? System.nanoTime() : Processor.BEAN.getCurrentThreadCpuTime();
  }

  /** Loaded when a pattern is first looked at, as it takes some milliseconds. */
  private static final class Processor {

    private static final ThreadMXBean BEAN = find();

    private Processor() {}

    private static ThreadMXBean find() {
      ThreadMXBean bean = ManagementFactory.getThreadMXBean();
      return bean.isCurrentThreadCpuTimeSupported() && bean.isThreadCpuTimeEnabled() ? bean : null;
    }
  }
}
