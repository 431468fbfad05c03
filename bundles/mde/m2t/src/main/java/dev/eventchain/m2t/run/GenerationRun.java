package dev.eventchain.m2t.run;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.m2t.files.GeneratedFiles;
import dev.eventchain.m2t.generation.GenerationContext;
import dev.eventchain.m2t.generation.GenerationContext.Trait;
import dev.eventchain.m2t.generation.GenerationResult;
import dev.eventchain.m2t.generation.GenerationRules;
import dev.eventchain.m2t.generation.GenerationTrace;
import dev.eventchain.m2t.report.CallStack;
import dev.eventchain.m2t.report.Called;
import dev.eventchain.m2t.report.RunReport;
import dev.eventchain.m2t.text.OutputBuffer;
import dev.eventchain.m2t.text.RunWriter;
import dev.eventchain.m2t.text.Texts;
import dev.eventchain.m2t.text.Tracing;
import dev.eventchain.m2t.text.Undefined;
import dev.eventchain.ocl.Evaluations;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.dialect.OperationLibrary;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.regex.Pattern;
import org.eclipse.emf.ecore.EObject;

/** State of one generation: values, files and active calls. For one thread. */
public final class GenerationRun {
  /** Depth of calls from which their memory is checked. */
  private static final int MANY_CALLS = 1000;

  /** Divisor of the heap size for the text and arguments of nested calls, without copies. */
  private static final int PART_OF_MEMORY = 16;

  /**
   * Limit for the text and arguments of nested calls in characters, because endless recursion needs
   * long to fill more.
   */
  private static final long MOST_HELD = 64L << 20;

  /**
   * Size of the pattern cache; more patterns come from the model, and their number is unbounded.
   */
  private static final int MOST_PATTERNS = 256;

  /** Thrown if generation cannot continue, after the reason was reported. */
  public static final class StoppedException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    StoppedException() {
      super("generation was stopped", null, false, false);
    }
  }

  private final Evaluation evaluation;
  private final GenerationContext context;
  private final CallStack calls;
  private final RunWriter writer;
  private final RunReport report;
  private final GeneratedFiles files;
  private final ObjectQueries objects;
  private final KeptValues kept = new KeptValues();
  private final Map<String, TokenWalk> tokenWalks = new HashMap<>();
  private final Map<String, Pattern> patterns = new HashMap<>();
  private final Map<Class<?>, Object> serviceInstances = new HashMap<>();
  private final boolean modelChanges;
  private Expression current;
  private boolean stopped;

  public GenerationRun(
      Collection<? extends EObject> roots, GenerationContext context, boolean modelChanges) {
    this.modelChanges = modelChanges;
    Evaluation fresh = Evaluations.over(roots).attach(this);
    this.evaluation = modelChanges ? fresh.withChangingModel() : fresh;
    this.context = context;
    this.calls = new CallStack(evaluation);
    Tracing tracing = context.has(Trait.TRACED) ? new Tracing(context.locator()) : null;
    this.writer = new RunWriter(tracing, calls::element);
    this.report = new RunReport(calls, context.locator());
    this.files = new GeneratedFiles(report, writer, calls::element, context);
    this.objects = new ObjectQueries(evaluation);
  }

  public Evaluation evaluation() {
    return evaluation;
  }

  /** Returns the active calls and loops. */
  public CallStack calls() {
    return calls;
  }

  public RunWriter writer() {
    return writer;
  }

  public OutputBuffer output() {
    return writer.output();
  }

  public RunReport report() {
    return report;
  }

  public GeneratedFiles files() {
    return files;
  }

  public ObjectQueries objects() {
    return objects;
  }

  public Optional<String> property(String key) {
    return context.property(key);
  }

  public Optional<String> property(String file, String key) {
    return context.property(file, key);
  }

  /** Returns the tokenizer of a text that {@code strtok} continues with. */
  public TokenWalk tokenWalk(String text, boolean restart) {
    if (restart) {
      tokenWalks.remove(text);
    }
    return tokenWalks.computeIfAbsent(text, TokenWalk::new);
  }

  /** Returns a compiled regular expression from a cache. */
  public Pattern pattern(String expression) {
    Pattern known = patterns.get(expression);
    if (known == null) {
      known = Pattern.compile(expression);
      if (patterns.size() >= MOST_PATTERNS) {
        patterns.clear();
      }
      patterns.put(expression, known);
    }
    return known;
  }

  /** Returns the instances of Java services with non-static methods, one of each class. */
  public Map<Class<?>, Object> serviceInstances() {
    return serviceInstances;
  }

  public GenerationResult result() {
    Tracing tracing = writer.tracing();
    GenerationTrace trace = tracing == null ? GenerationTrace.NONE : tracing.result();
    SortedMap<String, byte[]> contents = files.contents();
    List<Diagnostic> found = report.all();
    GenerationResult result = new GenerationResult(contents, files.printed(), found, trace);
    return context.has(Trait.LENIENT) ? result.lenient() : result;
  }

  /** Evaluates an expression for some use; an invalid value has been reported. */
  public Object evaluate(Expression expression, Undefined use) {
    return evaluate(expression, use, null, false);
  }

  /** Does {@link Expression#read}, or {@link #evaluate} if Java services may change the model. */
  public Object read(Expression expression, Undefined use) {
    return evaluate(expression, use, null, !modelChanges);
  }

  /** Does {@link Expression#evaluateCalls}; an invalid value has been reported. */
  public Object evaluateCalls(Expression expression, OperationLibrary.Implementation receiver) {
    return evaluate(expression, Undefined.TEXT, receiver, false);
  }

  private Object evaluate(
      Expression expression,
      Undefined use,
      OperationLibrary.Implementation receiver,
      boolean read) {
    Expression outer = current;
    current = expression;
    try {
      Object value;
      if (receiver != null) {
        value = expression.evaluateCalls(evaluation, receiver);
      } else {
        value = read ? expression.read(evaluation) : expression.evaluate(evaluation);
      }
      if (value instanceof Invalid invalid) {
        if (stopped) {
          throw new StoppedException();
        }
        if (invalid.limit()) {
          throw stop(invalid);
        }
        report.undefined(expression, invalid, use);
      }
      return value;
    } finally {
      current = outer;
    }
  }

  /** Returns the location of the current expression. */
  public SourceLocation place() {
    return current == null ? SourceLocation.NONE : current.location();
  }

  /** Returns whether a condition is true. */
  public boolean holds(Expression condition) {
    return Boolean.TRUE.equals(condition(condition, Undefined.GUARD));
  }

  /**
   * Evaluates a condition for some use to true, false, null, or an {@link Invalid}, which has been
   * reported. Any other value is reported and counts as false.
   */
  public Object condition(Expression condition, Undefined use) {
    Object value = evaluate(condition, use);
    if (value == null || value instanceof Boolean || value instanceof Invalid) {
      return value;
    }
    report.find(
        GenerationRules.CONDITION,
        condition.location(),
        "The condition is '" + Texts.of(value) + "', neither true nor false; it counts as false.",
        "Compare it with something, or use ->notEmpty().");
    return false;
  }

  /** Returns the cached values of queries. */
  public KeptValues kept() {
    return kept;
  }

  /** Begins a call, unless generation was stopped or nested calls take too much memory. */
  public void enter(Called called, List<Object> arguments) {
    if (stopped) {
      throw new StoppedException();
    }
    calls.enter(called, arguments, current);
    int depth = calls.depth();
    if (depth >= MANY_CALLS
        && output().weight(depth) + calls.weight()
            > Math.min(MOST_HELD, Runtime.getRuntime().maxMemory() / PART_OF_MEMORY)) {
      calls.keep();
      leave();
      throw stopTooDeep();
    }
  }

  public void leave() {
    calls.leave();
  }

  /** Appends a value of the current expression, with an indentation after each line break. */
  public void appendIndented(String text, String indentation) {
    writer.appendIndented(text, indentation, current);
  }

  /** Reports why generation cannot continue, and returns the exception to throw. */
  public StoppedException stop(Invalid invalid) {
    if (calls.tooDeep().isPresent()) {
      return stopTooDeep();
    }
    return invalid.kind() == Invalid.Kind.COST
        ? stop(
            Invalid.ABANDONED,
            invalid.reason(),
            invalid.location(),
            "Ask for less at once, or for the same in several steps.")
        : stopRecursion(invalid.reason(), invalid.location());
  }

  /**
   * Reports that generation cannot continue after calls were {@linkplain CallStack#keep kept}, and
   * returns the exception to throw.
   */
  public StoppedException stopTooDeep() {
    Called called = calls.tooDeep().orElseThrow();
    return stopRecursion(
        "'" + called.name() + "' recurses endlessly, or deeper than memory allows",
        called.place().location());
  }

  /** Returns whether calls are nested deeply enough to explain a lack of memory. */
  public boolean isTooDeep() {
    return calls.keptDepth() >= MANY_CALLS;
  }

  private StoppedException stopRecursion(String reason, SourceLocation location) {
    return stop(
        GenerationRules.RECURSION, reason, location, "End the recursion, for example by a guard.");
  }

  private StoppedException stop(Rule rule, String reason, SourceLocation location, String hint) {
    if (!stopped) {
      stopped = true;
      report.find(rule, location, "Generation was stopped: " + reason + ".", hint);
    }
    return new StoppedException();
  }
}
