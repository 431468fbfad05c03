package dev.eventchain.ocl.lower;

import dev.eventchain.ocl.model.ModelAccess;
import dev.eventchain.ocl.nodes.DefinitionNodes;
import dev.eventchain.ocl.nodes.Lowered;
import dev.eventchain.ocl.nodes.NavigationNodes;
import dev.eventchain.ocl.nodes.Node;
import dev.eventchain.ocl.nodes.NumberNodes;
import dev.eventchain.ocl.nodes.VirtualCall;
import dev.eventchain.ocl.parse.Libraries;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.ocl.expressions.OperationCallExp;
import org.eclipse.ocl.util.OCLStandardLibraryUtil;

/** Lowers calls of operations, distinguished in the order of Eclipse OCL. */
final class OperationLowering {

  private final BodyLowering body;
  private final Lowering lowering;
  private final StandardOperations standard;

  OperationLowering(BodyLowering body, Lowering lowering) {
    this.body = body;
    this.lowering = lowering;
    this.standard = new StandardOperations(lowering.environment(), lowering.model());
  }

  Node node(OperationCallExp<EClassifier, EOperation> call) {
    EOperation operation = call.getReferredOperation();
    Node source = body.node(call.getSource());
    Node[] arguments = body.nodes(call.getArgument());
    if (operation instanceof Libraries.LibraryOperation library) {
      return new DefinitionNodes.LibraryCall(
          call, call.getType(), library.implementation(), source, arguments);
    }
    Lowered definition = lowering.definition(operation);
    List<VirtualCall.Implementation> overrides =
        lowering.overrides(call.getSource().getType(), operation);
    if (!overrides.isEmpty()) {
      return virtual(call, overrides, source, arguments);
    } else if (definition != null) {
      return new DefinitionNodes.Call(source, arguments, definition);
    } else if (call.getOperationCode() <= 0) {
      return new NavigationNodes.Operation(
          operation, codeOf(operation), source, arguments, lowering.model());
    }
    return standard.node(call, source, arguments);
  }

  private Node virtual(
      OperationCallExp<EClassifier, EOperation> call,
      List<VirtualCall.Implementation> overrides,
      Node source,
      Node[] arguments) {
    EOperation operation = call.getReferredOperation();
    Lowered definition = lowering.definition(operation);
    List<VirtualCall.Implementation> all = new ArrayList<>(overrides);
    if (definition != null) {
      all.add(new VirtualCall.Implementation((EClass) call.getSource().getType(), definition));
    }
    ModelAccess environment = lowering.model();
    int code = codeOf(operation);
    return new VirtualCall(
        source,
        arguments,
        all,
        (object, values) -> environment.callOperation(operation, code, object, values));
  }

  /** Returns the code of an operation; comparisons of a metamodel have the standard codes. */
  private static int codeOf(EOperation operation) {
    int code = OCLStandardLibraryUtil.getOperationCode(String.valueOf(operation.getName()));
    return NumberNodes.Comparison.has(code) ? code : 0;
  }
}
