package dev.eventchain.pipeline.simulate;

import dev.eventchain.constraints.OclConstraint;
import dev.eventchain.constraints.OclResult;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.DataFlowIndex;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.run.SimulationOptions.Driver;
import dev.eventchain.pipeline.stage.RunContext;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * Components without a worst-case execution time in latencies that are bounded. In simulated time
 * they take none, so that the measured latency is only a lower bound and proves nothing.
 */
final class MissingTimes {

  private static final EventchainPackage METAMODEL = EventchainPackage.eINSTANCE;

  /** The latency of the whole chain. */
  private static final EStructuralFeature OF_CHAIN = METAMODEL.getChainMeasurement_Latency();

  /** The features by which a constraint reads bounded latencies. */
  private static final Set<EStructuralFeature> BOUNDED =
      Set.of(
          METAMODEL.getEventChain_LatencyConstraints(),
          METAMODEL.getLatencyConstraint_Maximum(),
          METAMODEL.getChainMeasurement_Latencies(),
          METAMODEL.getLatencyMeasurement_Latency());

  /** Bound of a latency that a component is part of, for users, by the component. */
  private final Map<SoftwareNode, Set<String>> bounds = new LinkedHashMap<>();

  private final Set<String> ids = new TreeSet<>();

  private MissingTimes() {}

  /**
   * Returns the missing times of a run of all scenarios; none in real time, where execution takes
   * its time.
   *
   * @param validation the constraints that were evaluated
   */
  static MissingTimes of(RunContext run, EventChain chain, OclResult validation) {
    Driver driver = run.options().simulation().driver();
    MissingTimes missing = new MissingTimes();
    boolean simulatedTime = driver == Driver.LOCKSTEP || driver == Driver.DDS;
    if (simulatedTime && !run.options().isPartial()) {
      missing.addConstraints(chain);
      Set<String> written =
          run.writtenRequirements().stream()
              .map(WrittenRequirement::id)
              .collect(Collectors.toCollection(TreeSet::new));
      for (OclResult.Check check : validation.checks()) {
        Set<String> named = new TreeSet<>(check.constraint().named(written));
        if (!named.isEmpty()) {
          missing.addRule(chain, check.constraint(), named);
        }
      }
    }
    return missing;
  }

  private void addConstraints(EventChain chain) {
    DataFlowIndex flow = DataFlowIndex.of(chain);
    for (LatencyConstraint each : chain.getLatencyConstraints()) {
      if (each.getFirst() != null && each.getLast() != null) {
        Set<SoftwareNode> behind = reachable(each.getFirst(), flow);
        add(
            behind.stream().filter(node -> reachable(node, flow).contains(each.getLast())).toList(),
            "the latency constraint '" + each.getName() + "'");
      }
    }
  }

  /** Returns a component and all that data of it reach. */
  private static Set<SoftwareNode> reachable(SoftwareNode first, DataFlowIndex flow) {
    Set<SoftwareNode> reached = new LinkedHashSet<>(Set.of(first));
    reached.addAll(flow.behind(first));
    return reached;
  }

  private void addRule(EventChain chain, OclConstraint rule, Set<String> named) {
    Set<EStructuralFeature> read = new HashSet<>();
    rule.navigations().forEach(each -> read.add(each.feature()));
    boolean ofChain =
        read.contains(OF_CHAIN) && add(components(chain), "'" + rule.qualifiedName() + "'");
    if (ofChain || (!bounds.isEmpty() && !Collections.disjoint(read, BOUNDED))) {
      ids.addAll(named);
    }
  }

  private static List<SoftwareNode> components(EventChain chain) {
    return chain.getSoftware().stream()
        .filter(node -> node.getImplementation() == ComponentImplementation.COMPONENT)
        .toList();
  }

  /** Adds a bound of the components without a time; returns whether there are any. */
  private boolean add(Collection<SoftwareNode> nodes, String bound) {
    List<SoftwareNode> without = nodes.stream().filter(MissingTimes::hasNoTime).toList();
    without.forEach(node -> bounds.computeIfAbsent(node, it -> new LinkedHashSet<>()).add(bound));
    return !without.isEmpty();
  }

  private static boolean hasNoTime(SoftwareNode node) {
    return !node.isSetWorstCaseExecutionTime() || node.getWorstCaseExecutionTime() <= 0;
  }

  /** Returns the requirements that bound a latency without all its times. */
  Set<String> ids() {
    return ids;
  }

  /** Returns a finding for each component without a time in a bounded latency. */
  List<Diagnostic> findings(Function<EObject, SourceLocation> locator) {
    List<Diagnostic> found = new ArrayList<>();
    bounds.forEach((node, bound) -> found.add(finding(node, bound, locator.apply(node))));
    return found;
  }

  private static Diagnostic finding(SoftwareNode node, Set<String> bound, SourceLocation place) {
    return Diagnostic.of(
            SimulateRules.SIMULATION_LATENCY_LOWER_BOUND,
            "'%s' has no worst-case execution time, so that what was measured for %s is only a lower bound."
                .formatted(node.getName(), String.join(" and ", bound)),
            place)
        .withHint(
            "State worst_case_execution_time in components.json (worstCaseExecutionTime in a model), in ms, or suppress this finding with a reason and an expiry date.");
  }
}
