package dev.eventchain.contracts;

import dev.eventchain.contracts.latency.Deployment;
import dev.eventchain.contracts.timing.ResponseTimes.Outcome;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainPackage.Literals;
import dev.eventchain.model.eventchain.Processor;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Processors against what the components on them need. Only a utilisation above 1 is an error,
 * since no phases and no order of execution help. Unknown times never count as 0.
 */
final class ProcessorContracts {

  private final Findings findings;

  ProcessorContracts(Findings findings) {
    this.findings = findings;
  }

  void check(EventChain chain) {
    Deployment.of(chain).loads().forEach(this::check);
  }

  private void check(Deployment.Load load) {
    findings.checked(ContractRule.PROCESSOR_OVERLOADED);
    findings.checked(ContractRule.PROCESSOR_UNKNOWN);
    if (load.isOverloaded()) {
      overloaded(load);
    } else {
      load.shares().forEach(share -> checkResponse(load, share));
    }
    List<String> unknown =
        load.shares().stream().map(Deployment.Share::unknown).flatMap(Optional::stream).toList();
    if (!unknown.isEmpty()) {
      findings.info(
          ContractRule.PROCESSOR_UNKNOWN,
          findings.at(load.processor(), Literals.PROCESSOR__NAME),
          "The utilisation of %s is not known: %s. It is %s at least."
              .formatted(name(load.processor()), String.join("; ", unknown), percent(load.known())),
          "State it where the model has a place for it. What is not known may fit, or may not.");
    }
  }

  private void overloaded(Deployment.Load load) {
    findings.error(
        ContractRule.PROCESSOR_OVERLOADED,
        findings.at(load.processor(), Literals.PROCESSOR__NAME),
        "The components on %s need %s of its time: %s."
            .formatted(
                name(load.processor()),
                percent(load.known()),
                load.shares().stream()
                    .flatMap(
                        share ->
                            share.utilisation().stream()
                                .map(part -> name(share.node()) + " " + percent(part)))
                    .collect(Collectors.joining(", "))),
        "No priorities and no phases help: map a component to another processor, execute one less often, or make one faster.");
  }

  private void checkResponse(Deployment.Load load, Deployment.Share share) {
    if (share.response().outcome() != Outcome.UNKNOWN) {
      findings.checked(ContractRule.PROCESSOR_LATE);
    }
    // Alone, a component is at most as late as its times are rounded.
    if (share.response().outcome() == Outcome.LATE && !load.before(share.node()).isEmpty()) {
      findings.warning(
          ContractRule.PROCESSOR_LATE,
          findings.at(share.node(), Literals.SOFTWARE_NODE__MAPPED_TO),
          "%s may end after its period, since it waits on %s for %s."
              .formatted(
                  name(share.node()),
                  name(load.processor()),
                  load.before(share.node()).stream()
                      .map(ProcessorContracts::name)
                      .collect(Collectors.joining(", "))),
          load.ordered()
              ? "Give it a higher priority, map it to another processor, or make what goes first faster."
              : "State a priority for each component on the processor; as long as one has none, any of them may go first.");
    }
  }

  private static String name(SoftwareNode node) {
    return "'" + node.getName() + "'";
  }

  private static String name(Processor processor) {
    return "'" + processor.getName() + "'";
  }

  /** Returns a part as a percentage, rounded up, so that nothing above all looks like all. */
  private static String percent(BigDecimal part) {
    BigDecimal percent = part.movePointRight(2).setScale(1, RoundingMode.CEILING);
    return (percent.signum() == 0 ? "0" : percent.stripTrailingZeros().toPlainString()) + " %";
  }
}
