package dev.eventchain.contracts;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.DataFlowIndex;
import dev.eventchain.model.Signal;
import dev.eventchain.model.eventchain.EventChain;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * Checks of a chain beyond OCL: agreement of components and vehicle on each topic, which otherwise
 * fails silently at run time, and properties of the data flow.
 *
 * <p>The standard constraints check single elements; data without a topic, a legal type or a field
 * are skipped here.
 */
public final class ChainAnalysis {

  private final MessageCatalog catalog;
  private final Optional<Map<String, Signal>> signals;

  private ChainAnalysis(MessageCatalog catalog, Optional<Map<String, Signal>> signals) {
    this.catalog = catalog;
    this.signals = signals;
  }

  /**
   * Returns an analysis of chains for one vehicle.
   *
   * @param catalog the known message types
   * @param signals the topics outside the chain; empty if unknown, so that publishers and
   *     subscribers outside the chain are not checked
   */
  public static ChainAnalysis of(MessageCatalog catalog, Optional<List<Signal>> signals) {
    return new ChainAnalysis(catalog, signals.map(ChainAnalysis::byTopic));
  }

  private static Map<String, Signal> byTopic(List<Signal> signals) {
    Map<String, Signal> byTopic = new LinkedHashMap<>();
    signals.forEach(signal -> byTopic.putIfAbsent(RosNames.resolve(signal.topic(), ""), signal));
    return byTopic;
  }

  /**
   * Checks a chain, and the definitions in the user's folders of messages.
   *
   * @param locator returns the locations of the features of the chain's elements
   */
  public AnalysisResult check(
      EventChain chain, BiFunction<EObject, EStructuralFeature, SourceLocation> locator) {
    Findings findings = new Findings(locator);
    findings.addAll(catalog.diagnostics());
    List<Topic> topics = Topic.of(chain, signals.orElse(Map.of()));
    TypeContracts types = new TypeContracts(catalog, findings);
    DataFlowIndex flow = DataFlowIndex.of(chain);
    TopicContracts partners = new TopicContracts(topics, signals, flow, types, findings);
    SignalContracts described = new SignalContracts(types, findings);
    UnitContracts units = new UnitContracts(findings);
    ConversionContracts conversions = new ConversionContracts(types, findings);
    AgeContracts ages = new AgeContracts(types, findings);
    QosContracts qos = new QosContracts(findings);
    for (Topic topic : topics) {
      types.check(topic);
      partners.check(topic);
      described.check(topic);
      units.check(topic);
      conversions.check(topic);
      ages.check(topic);
      qos.check(topic);
    }
    new SynchronizationContracts(types, findings).check(chain);
    new FlowRules(chain, flow, signals, findings).check();
    new LatencyContracts(chain, findings).check();
    new ProcessorContracts(findings).check(chain);
    return findings.result();
  }
}
