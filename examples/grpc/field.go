// A field from a server, with grpc-go and the stubs of `protoc --go_out --go-grpc_out`
// as package `geodesic`; and the reason that an error has for programs.

package field

import (
	"context"
	"encoding/binary"
	"io"
	"math"
	"time"

	"google.golang.org/genproto/googleapis/rpc/errdetails"
	"google.golang.org/grpc"
	"google.golang.org/grpc/status"

	"example.org/geodesic"
)

func distancesFrom(conn *grpc.ClientConn, mesh string, vertex uint64) ([]float64, error) {
	ctx, cancel := context.WithTimeout(context.Background(), time.Minute)
	defer cancel() // also when the loop is left early
	stream, err := geodesic.NewFieldServiceClient(conn).ComputeField(ctx,
		&geodesic.ComputeFieldRequest{MeshDigest: mesh, Sources: []*geodesic.Source{
			{Place: &geodesic.Source_Vertex{Vertex: vertex}}}})
	if err != nil {
		return nil, err
	}
	var distances []float64
	complete := false
	for {
		answer, err := stream.Recv()
		if err == io.EOF && complete {
			return distances, nil
		} else if err != nil {
			return nil, err
		}
		values := answer.GetChunk().GetDistances()
		for at := 0; at < len(values); at += 8 {
			distances = append(distances, math.Float64frombits(
				binary.LittleEndian.Uint64(values[at:])))
		}
		complete = answer.GetTrailer() != nil
	}
}

func reasonOf(err error) string {
	for _, detail := range status.Convert(err).Details() {
		if info, ok := detail.(*errdetails.ErrorInfo); ok {
			return info.Reason
		}
	}
	return ""
}
