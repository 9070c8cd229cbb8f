/* For wine alone: versions before 9 lack this library of Windows, which every program in Rust loads for its random numbers.
   `scripts/cross --wine` puts it beside the executable that it tests; no package has it. */
#include <windows.h>

BOOLEAN NTAPI SystemFunction036(PVOID buffer, ULONG length);

__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE buffer, SIZE_T length)
{
    return SystemFunction036(buffer, (ULONG)length);
}
