/** Language services for texts with expressions, whatever is around these. */
package dev.eventchain.ocl.assist;
